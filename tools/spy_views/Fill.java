package pico.spy;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.Rectangle;
import java.awt.TexturePaint;
import java.awt.image.BufferedImage;

/** What the inside of an area looks like. */
enum Fill {
  NONE,
  TINT,
  SOLID,
  HATCH,
  CROSS_HATCH;

  private static final int TILE = 8;
  private static final int TINT_ALPHA = 60;

  Paint paint(Color colour) {
    return switch (this) {
      case NONE -> new Color(0, 0, 0, 0);
      case TINT -> new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), TINT_ALPHA);
      case SOLID -> colour;
      case HATCH, CROSS_HATCH -> hatched(colour);
    };
  }

  private Paint hatched(Color colour) {
    BufferedImage tile = new BufferedImage(TILE, TILE, BufferedImage.TYPE_INT_ARGB);
    Graphics2D graphics = tile.createGraphics();
    graphics.setColor(colour);
    graphics.drawLine(0, TILE - 1, TILE - 1, 0);
    if (this == CROSS_HATCH) graphics.drawLine(0, 0, TILE - 1, TILE - 1);
    graphics.dispose();
    return new TexturePaint(tile, new Rectangle(TILE, TILE));
  }
}
