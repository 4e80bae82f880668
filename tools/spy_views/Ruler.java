package pico.spy;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;

/** A grid under a drawing, a scale bar of one of its squares, and which way x and y point. */
final class Ruler {
  private static final double SQUARE = 60;  // [px] a side of the grid's squares at least
  private static final Color VEIL = new Color(255, 255, 255, 160);
  private static final BasicStroke THIN = new BasicStroke(1f);
  private static final BasicStroke THICK = new BasicStroke(3f);

  private final double step;  // [m]
  private final double scale;

  Ruler(double pixelsPerMetre) {
    scale = pixelsPerMetre;
    step = roundUp(SQUARE / scale);
  }

  /** To the next 1, 2 or 5 times a power of ten. */
  private static double roundUp(double length) {
    double power = Math.pow(10, Math.floor(Math.log10(length)));
    for (double factor : new double[] {1, 2, 5}) {
      if (factor * power >= length * (1 - 1e-9)) return factor * power;
    }
    return 10 * power;
  }

  void drawGrid(Graphics2D graphics, AffineTransform metresToPixels, Rectangle2D visible) {
    graphics.setColor(Palette.GRID);
    graphics.setStroke(THIN);
    double left = visible.getMinX();
    double right = visible.getMaxX();
    double low = visible.getMinY();
    double high = visible.getMaxY();
    for (double x = Math.ceil(left / step) * step; x <= right; x += step)
      graphics.draw(metresToPixels.createTransformedShape(new Line2D.Double(x, low, x, high)));
    for (double y = Math.ceil(low / step) * step; y <= high; y += step)
      graphics.draw(metresToPixels.createTransformedShape(new Line2D.Double(left, y, right, y)));
  }

  void drawScaleBar(Graphics2D graphics, Dimension size) {
    int length = (int) Math.round(step * scale);
    int x = 14;
    int y = size.height - 14;
    graphics.setColor(VEIL);
    graphics.fillRect(x - 6, y - 24, length + 12, 32);
    graphics.setColor(Palette.BLACK);
    graphics.setStroke(THICK);
    graphics.drawLine(x, y, x + length, y);
    graphics.setStroke(THIN);
    graphics.drawLine(x - 1, y - 5, x - 1, y + 4);
    graphics.drawLine(x + length + 1, y - 5, x + length + 1, y + 4);
    graphics.drawString(lengthText(), x + 4, y - 7);
  }

  private String lengthText() {
    if (step >= 1) return Text.of("%.0f m", step);
    if (step >= 0.01) return Text.of("%.0f cm", step * 100);
    return Text.of("%.1f mm", step * 1000);
  }

  void drawAxes(Graphics2D graphics, AffineTransform metresToPixels) {
    graphics.setColor(Palette.DARK_GREY);
    graphics.setStroke(THIN);
    Point2D x = metresToPixels.deltaTransform(new Point2D.Double(26 / scale, 0), null);
    Point2D y = metresToPixels.deltaTransform(new Point2D.Double(0, 26 / scale), null);
    double left = Math.min(0, Math.min(x.getX(), y.getX()));
    double originX = 26 - left;
    double originY = 50;
    for (Point2D axis : new Point2D[] {x, y}) {
      graphics.draw(new Line2D.Double(originX, originY, originX + axis.getX(),
          originY + axis.getY()));
      graphics.drawString(axis == x ? "x" : "y", (float) (originX + axis.getX() * 1.35 - 3),
          (float) (originY + axis.getY() * 1.35 + 4));
    }
  }
}
