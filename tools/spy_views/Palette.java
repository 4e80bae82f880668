package pico.spy;

import java.awt.Color;

/**
 * The colours of M. Okabe and K. Ito, "Color Universal Design" (2008), which the colour-blind
 * tell apart on white, and greys for what is no data.
 */
final class Palette {
  static final Color BLACK = new Color(0x000000);
  static final Color ORANGE = new Color(0xE69F00);
  static final Color SKY_BLUE = new Color(0x56B4E9);
  static final Color GREEN = new Color(0x009E73);
  static final Color BLUE = new Color(0x0072B2);
  static final Color VERMILION = new Color(0xD55E00);
  static final Color PURPLE = new Color(0xCC79A7);
  static final Color DARK_GREY = new Color(0x505050);
  static final Color GRID = new Color(0xE8E8E8);

  private Palette() {}
}
