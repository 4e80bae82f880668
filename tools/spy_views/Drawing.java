package pico.spy;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import javax.swing.ToolTipManager;

/**
 * Draws a scene. The wheel zooms at the cursor, dragging pans, a double click shows all of the
 * scene again, and pointing at a thing tells what it is.
 */
final class Drawing extends JComponent {
  static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
  private static final double WHEEL_STEP = 1.15;
  private static final BasicStroke POINTER = new BasicStroke(10);  // [px] wide a line to point at

  private final transient Camera camera = new Camera();
  private transient Scene scene;

  Drawing() {
    Mouse mouse = new Mouse();
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
    addMouseWheelListener(mouse);
    setFont(FONT);
    ToolTipManager.sharedInstance().registerComponent(this);
  }

  void show(Scene newest) {
    scene = newest;
    repaint();
  }

  @Override
  protected void paintComponent(Graphics original) {
    Graphics2D graphics = (Graphics2D) original.create();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING,
        RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL,
        RenderingHints.VALUE_STROKE_PURE);
    graphics.setColor(Color.WHITE);
    graphics.fillRect(0, 0, getWidth(), getHeight());
    if (scene != null) paint(graphics, scene);
    graphics.dispose();
  }

  private void paint(Graphics2D graphics, Scene shown) {
    camera.follow(shown, getSize());
    AffineTransform metresToPixels = camera.metresToPixels(getSize());
    Ruler ruler = new Ruler(camera.scale());
    ruler.drawGrid(graphics, metresToPixels, camera.visible(getSize()));
    for (Scene.Item item : shown.items()) paint(graphics, metresToPixels, item);
    ruler.drawScaleBar(graphics, getSize());
    ruler.drawAxes(graphics, metresToPixels);
  }

  private static void paint(Graphics2D graphics, AffineTransform metresToPixels, Scene.Item item) {
    if (item.shape() != null) {
      item.style().draw(graphics, metresToPixels.createTransformedShape(item.shape()));
      return;
    }
    Point2D at = metresToPixels.transform(new Point2D.Double(item.x(), item.y()), null);
    Point2D ahead = metresToPixels.deltaTransform(
        new Point2D.Double(Math.cos(item.heading()), Math.sin(item.heading())), null);
    double turn = Math.atan2(ahead.getX(), -ahead.getY());
    item.style().drawMark(graphics, at.getX(), at.getY(), turn);
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    if (scene == null) return null;
    AffineTransform metresToPixels = camera.metresToPixels(getSize());
    return scene.items().stream()
        .filter(item -> item.text() != null)
        .filter(item -> POINTER
            .createStrokedShape(metresToPixels.createTransformedShape(item.shape()))
            .contains(event.getPoint()))
        .map(Scene.Item::text)
        .findFirst()
        .orElse(null);
  }

  private final class Mouse extends MouseAdapter {
    private Point grabbed;

    @Override
    public void mousePressed(MouseEvent event) {
      grabbed = event.getPoint();
    }

    @Override
    public void mouseDragged(MouseEvent event) {
      if (grabbed == null || !SwingUtilities.isLeftMouseButton(event)) return;
      camera.pan(grabbed, event.getPoint(), getSize());
      grabbed = event.getPoint();
      repaint();
    }

    @Override
    public void mouseClicked(MouseEvent event) {
      if (event.getClickCount() != 2) return;
      camera.fit();
      repaint();
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
      double factor = Math.pow(WHEEL_STEP, -event.getPreciseWheelRotation());
      camera.zoom(factor, event.getPoint(), getSize());
      repaint();
    }
  }
}
