package pico.spy;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/** Symbols that stand at a point and have a size of the screen, in pixels around (0, 0). */
enum Mark {
  DOT(new Rectangle2D.Double(-1.5, -1.5, 3, 3), true),
  DISC(new Ellipse2D.Double(-4, -4, 8, 8), true),
  RING(new Ellipse2D.Double(-4, -4, 8, 8), false),
  SQUARE(new Rectangle2D.Double(-4, -4, 8, 8), true),
  BOX(new Rectangle2D.Double(-5, -5, 10, 10), false),
  TRIANGLE(polygon(0, -6, 6, 5, -6, 5), true),
  DIAMOND(polygon(0, -7, 7, 0, 0, 7, -7, 0), true),
  CROSS(cross(6), false),
  /** Points up; the only one that is turned into its heading. */
  ARROW(polygon(0, -13, 8, 9, 0, 4, -8, 9), true);

  private final Shape shape;
  final boolean filled;

  Mark(Shape shape, boolean filled) {
    this.shape = shape;
    this.filled = filled;
  }

  /** At a point of the screen, turned clockwise [rad]. */
  Shape at(double x, double y, double turn) {
    AffineTransform place = AffineTransform.getTranslateInstance(x, y);
    if (this == ARROW) place.rotate(turn);
    return place.createTransformedShape(shape);
  }

  private static Path2D polygon(double... xy) {
    Path2D path = new Path2D.Double();
    path.moveTo(xy[0], xy[1]);
    for (int i = 2; i < xy.length; i += 2) path.lineTo(xy[i], xy[i + 1]);
    path.closePath();
    return path;
  }

  private static Path2D cross(double reach) {
    Path2D path = new Path2D.Double();
    path.moveTo(-reach, -reach);
    path.lineTo(reach, reach);
    path.moveTo(-reach, reach);
    path.lineTo(reach, -reach);
    return path;
  }
}
