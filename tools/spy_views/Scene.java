package pico.spy;

import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * What one message looks like: shapes and marks in metres, drawn in the order in which they were
 * added. Nothing gets in that is not finite, or too far away for lines to be dashed in good time.
 */
final class Scene {
  /** Where x points on the screen. */
  enum Up {
    /** x, the robot's forward, points up, and y to the left. */
    X,
    /** y points up, and x to the right: a plan of a building. */
    Y
  }

  /** A shape [m], or a mark at (x, y) [m] with its heading [rad]; and what it is, or null. */
  record Item(Style style, Shape shape, double x, double y, double heading, String text) {}

  private static final double FARTHEST = 1e5;  // [m]

  final Up up;
  final String summary;
  private final List<Item> items = new ArrayList<>();
  private Rectangle2D extent;

  /** The summary is the text of the status line. */
  Scene(Up up, String summary) {
    this.up = up;
    this.summary = summary;
  }

  List<Item> items() {
    return Collections.unmodifiableList(items);
  }

  /** What has to be in sight [m]; null for an empty scene. */
  Rectangle2D extent() {
    return extent;
  }

  void line(Style style, double x1, double y1, double x2, double y2) {
    shape(style, new Line2D.Double(x1, y1, x2, y2));
  }

  void shape(Style style, Shape shape) {
    shape(style, shape, null);
  }

  /** The text is told to whoever points at it. */
  void shape(Style style, Shape shape, String text) {
    Rectangle2D bounds = shape.getBounds2D();
    boolean isEmpty = shape.getPathIterator(null).isDone();
    if (isEmpty || !isNear(bounds)) return;
    items.add(new Item(style, shape, 0, 0, 0, text));
    include(bounds);
  }

  void mark(Style style, double x, double y) {
    arrow(style, x, y, 0);
  }

  void arrow(Style style, double x, double y, double heading) {
    Rectangle2D point = new Rectangle2D.Double(x, y, 0, 0);
    if (!isNear(point) || !Double.isFinite(heading)) return;
    items.add(new Item(style, null, x, y, heading, null));
    include(point);
  }

  private void include(Rectangle2D bounds) {
    extent = extent == null ? bounds : extent.createUnion(bounds);
  }

  private static boolean isNear(Rectangle2D bounds) {
    return bounds.getMinX() >= -FARTHEST && bounds.getMaxX() <= FARTHEST
        && bounds.getMinY() >= -FARTHEST && bounds.getMaxY() <= FARTHEST;
  }
}
