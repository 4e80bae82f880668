package pico.spy;

/** The robot's place, heading along the arrow; its size is the screen's, no message tells it. */
final class Robot {
  static final Style STYLE = Style.mark("robot", Palette.BLACK, Mark.ARROW);

  private Robot() {}

  static void add(Scene scene, double x, double y, double heading) {
    scene.arrow(STYLE, x, y, heading);
  }
}
