package pico.spy;

import java.awt.BasicStroke;

/** How a line is broken, in pixels of line and gap. */
enum Dash {
  NONE(),
  DOTS(2, 4),
  DASHES(7, 5),
  DASHES_DOTS(12, 4, 2, 4);

  private final float[] pattern;

  Dash(float... pattern) {
    this.pattern = pattern;
  }

  BasicStroke stroke(float width) {
    return new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10f,
        pattern.length == 0 ? null : pattern, 0f);
  }
}
