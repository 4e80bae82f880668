package pico.spy;

import java.awt.Color;
import pico.status_input_t;

/** The state of a component's input, as a word with a sign and a colour of its own. */
enum InputState {
  WAITING("\u25cb waiting", Palette.ORANGE),
  OK("\u25cf ok", Palette.GREEN),
  STALE("\u25b2 stale", Palette.VERMILION),
  UNKNOWN("? unknown", Palette.PURPLE);

  private final String text;
  final Color colour;

  InputState(String text, Color colour) {
    this.text = text;
    this.colour = colour;
  }

  static InputState of(status_input_t input) {
    return switch (input.state) {
      case status_input_t.WAITING -> WAITING;
      case status_input_t.OK -> OK;
      case status_input_t.STALE -> STALE;
      default -> UNKNOWN;
    };
  }

  @Override
  public String toString() {
    return text;
  }
}
