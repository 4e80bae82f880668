package pico.spy;

import java.awt.BorderLayout;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JPanel;

/** A drawing with its legend. */
final class SceneDisplay implements Display<Scene> {
  private final JPanel panel = new JPanel(new BorderLayout());
  private final Drawing drawing = new Drawing();

  SceneDisplay(List<Style> legend) {
    panel.add(drawing, BorderLayout.CENTER);
    panel.add(new Legend(legend), BorderLayout.EAST);
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void show(Scene newest) {
    drawing.show(newest);
  }

  @Override
  public String summary(Scene newest) {
    return newest.summary;
  }
}
