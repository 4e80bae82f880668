package pico.spy;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.List;
import javax.swing.JComponent;

/** A strip beside a drawing that names what is drawn how. */
final class Legend extends JComponent {
  private static final int ROW = 21;
  private static final int SAMPLE = 30;
  private static final int GAP = 8;
  private static final int HINT_ROW = 16;
  private static final List<String> HINTS =
      List.of("wheel: zoom", "drag: pan", "double click: fit");

  private final transient List<Style> styles;

  Legend(List<Style> styles) {
    this.styles = styles;
    setFont(Drawing.FONT);
    FontMetrics metrics = getFontMetrics(getFont());
    int widest = styles.stream().mapToInt(style -> metrics.stringWidth(style.name)).max().orElse(0);
    setPreferredSize(new Dimension(GAP + SAMPLE + GAP + widest + GAP, styles.size() * ROW + GAP));
  }

  @Override
  protected void paintComponent(Graphics original) {
    Graphics2D graphics = (Graphics2D) original.create();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING,
        RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setColor(Color.WHITE);
    graphics.fillRect(0, 0, getWidth(), getHeight());
    graphics.setColor(Palette.GRID);
    graphics.drawLine(0, 0, 0, getHeight());
    int y = GAP;
    for (Style style : styles) {
      style.drawSample(graphics, GAP, y, SAMPLE, ROW);
      graphics.setColor(Palette.BLACK);
      graphics.drawString(style.name, GAP + SAMPLE + GAP, y + ROW / 2 + 4);
      y += ROW;
    }
    graphics.setColor(Palette.DARK_GREY);
    y = getHeight() - HINTS.size() * HINT_ROW;
    for (String hint : HINTS) {
      graphics.drawString(hint, GAP, y);
      y += HINT_ROW;
    }
    graphics.dispose();
  }
}
