package pico.spy;

import java.awt.Dimension;
import java.awt.geom.AffineTransform;
import java.awt.geom.NoninvertibleTransformException;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;

/**
 * Which part of a scene is on the screen. It follows the scene until somebody zooms or pans, and
 * again after fit().
 */
final class Camera {
  private static final double SMALLEST = 0.5;   // [px/m]
  private static final double LARGEST = 5000;   // [px/m]
  private static final double FARTHEST = 1e6;   // [m]
  private static final double MARGIN = 1.12;    // so that nothing lies on the edge
  private static final double EDGE = 16;        // [px] what comes closer to it leaves the view
  private static final double TOO_SMALL = 0.6;  // share of the view that a scene fills at least

  private Scene.Up up = Scene.Up.X;
  private double x;
  private double y;
  private double scale = 50;  // [px/m]
  private boolean following = true;
  private boolean stale = true;
  private Dimension lastSize = new Dimension();

  double scale() {
    return scale;
  }

  AffineTransform metresToPixels(Dimension size) {
    AffineTransform transform =
        AffineTransform.getTranslateInstance(size.width / 2.0, size.height / 2.0);
    transform.concatenate(up == Scene.Up.X ? new AffineTransform(0, -scale, -scale, 0, 0, 0)
                                           : new AffineTransform(scale, 0, 0, -scale, 0, 0));
    transform.translate(-x, -y);
    return transform;
  }

  /** Moves only when the scene leaves the view or has become small in it: a scan breathes. */
  void follow(Scene scene, Dimension size) {
    if (scene.up != up) {
      up = scene.up;
      fit();
    }
    Rectangle2D extent = scene.extent();
    if (!following || extent == null || size.width <= 0 || size.height <= 0) return;
    boolean tooSmall = scaleToFit(extent, size) * TOO_SMALL > scale;
    if (!stale && isInSight(extent, size) && !tooSmall && size.equals(lastSize)) return;
    x = clamp(extent.getCenterX(), -FARTHEST, FARTHEST);
    y = clamp(extent.getCenterY(), -FARTHEST, FARTHEST);
    scale = scaleToFit(extent, size);
    stale = false;
    lastSize = size;
  }

  /** Follows the scene again. */
  void fit() {
    following = true;
    stale = true;
  }

  /** The point under the cursor stays where it is. */
  void zoom(double factor, Point2D cursor, Dimension size) {
    Point2D before = toMetres(cursor, size);
    scale = clamp(scale * factor, SMALLEST, LARGEST);
    Point2D after = toMetres(cursor, size);
    moveBy(before.getX() - after.getX(), before.getY() - after.getY());
  }

  void pan(Point2D from, Point2D to, Dimension size) {
    Point2D start = toMetres(from, size);
    Point2D end = toMetres(to, size);
    moveBy(start.getX() - end.getX(), start.getY() - end.getY());
  }

  /** [m] */
  Rectangle2D visible(Dimension size) {
    Rectangle2D corners = new Rectangle2D.Double();
    corners.setFrameFromDiagonal(toMetres(new Point2D.Double(0, 0), size),
        toMetres(new Point2D.Double(size.width, size.height), size));
    return corners;
  }

  private boolean isInSight(Rectangle2D extent, Dimension size) {
    Rectangle2D seen = visible(size);
    double edge = EDGE / scale;
    return extent.getMinX() >= seen.getMinX() + edge && extent.getMaxX() <= seen.getMaxX() - edge
        && extent.getMinY() >= seen.getMinY() + edge && extent.getMaxY() <= seen.getMaxY() - edge;
  }

  private void moveBy(double dx, double dy) {
    following = false;
    x = clamp(x + dx, -FARTHEST, FARTHEST);
    y = clamp(y + dy, -FARTHEST, FARTHEST);
  }

  private double scaleToFit(Rectangle2D extent, Dimension size) {
    double across = up == Scene.Up.X ? extent.getHeight() : extent.getWidth();
    double upward = up == Scene.Up.X ? extent.getWidth() : extent.getHeight();
    double least = 0.5;  // [m] a lone point has no size of its own
    double fitting = Math.min(size.width / Math.max(across, least),
        size.height / Math.max(upward, least));
    return clamp(fitting / MARGIN, SMALLEST, LARGEST);
  }

  private Point2D toMetres(Point2D pixel, Dimension size) {
    try {
      return metresToPixels(size).inverseTransform(pixel, null);
    } catch (NoninvertibleTransformException e) {
      throw new IllegalStateException(e);  // the scale is never zero
    }
  }

  private static double clamp(double value, double low, double high) {
    return Math.max(low, Math.min(high, value));
  }
}
