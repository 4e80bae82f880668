package pico.spy;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;

/** How one kind of thing looks, on the drawing and in the legend: the two cannot differ. */
final class Style {
  private static final BasicStroke MARK_STROKE = new BasicStroke(2f);

  final String name;
  private final Color colour;
  private final BasicStroke stroke;
  private final Paint inside;
  private final Fill fill;
  private final Mark mark;

  private Style(String name, Color colour, BasicStroke stroke, Fill fill, Mark mark) {
    this.name = name;
    this.colour = colour;
    this.stroke = stroke;
    this.inside = fill.paint(colour);
    this.fill = fill;
    this.mark = mark;
  }

  /** Width in pixels. */
  static Style line(String name, Color colour, double width, Dash dash) {
    return area(name, colour, width, dash, Fill.NONE);
  }

  /** Width of the outline in pixels. */
  static Style area(String name, Color colour, double width, Dash dash, Fill fill) {
    return new Style(name, colour, dash.stroke((float) width), fill, null);
  }

  static Style mark(String name, Color colour, Mark mark) {
    return new Style(name, colour, MARK_STROKE, Fill.NONE, mark);
  }

  boolean isMark() {
    return mark != null;
  }

  /** Of a shape in pixels. */
  void draw(Graphics2D graphics, Shape shape) {
    if (fill != Fill.NONE) {
      graphics.setPaint(inside);
      graphics.fill(shape);
    }
    graphics.setColor(colour);
    graphics.setStroke(stroke);
    graphics.draw(shape);
  }

  /** At a point in pixels, turned clockwise [rad] where the mark has a heading. */
  void drawMark(Graphics2D graphics, double x, double y, double turn) {
    Shape shape = mark.at(x, y, turn);
    graphics.setColor(colour);
    graphics.setStroke(MARK_STROKE);
    if (mark.filled) {
      graphics.fill(shape);
    } else {
      graphics.draw(shape);
    }
  }

  /** What stands in the legend before the name. */
  void drawSample(Graphics2D graphics, int x, int y, int width, int height) {
    if (mark != null) {
      drawMark(graphics, x + width / 2.0, y + height / 2.0, 0);
    } else if (fill != Fill.NONE) {
      draw(graphics, new Rectangle2D.Double(x + 1, y + 3, width - 2, height - 6));
    } else {
      double middle = y + height / 2.0;
      draw(graphics, new Line2D.Double(x, middle, x + width, middle));
    }
  }
}
