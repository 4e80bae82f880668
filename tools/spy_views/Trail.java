package pico.spy;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import pico.pose_t;

/** The robot's way so far. A new session, a new frame, and time that steps back begin anew. */
final class Trail {
  private static final int LONGEST = 5000;          // places: 100 m of way and more
  private static final double SPACING = 0.02;       // [m] between places
  private static final long STEP_BACK = 2_000_000;  // [us] a smaller one is a message too late
  private static final double SIGMAS = 2;

  private static final Style WAY = Style.line("way so far", Palette.BLUE, 2.5, Dash.NONE);
  private static final Style GUESS = Style.line("guessed", Palette.ORANGE, 2, Dash.DASHES);
  private static final Style GUESSED_ROBOT =
      Style.mark("robot, a guess", Palette.ORANGE, Mark.ARROW);
  private static final Style START = Style.mark("start", Palette.GREEN, Mark.BOX);
  private static final Style SPREAD =
      Style.area("may be here (2 sigma)", Palette.PURPLE, 1.5, Dash.DOTS, Fill.TINT);

  static final List<Style> LEGEND =
      List.of(WAY, START, Robot.STYLE, GUESS, GUESSED_ROBOT, SPREAD);

  private final Deque<Fix> places = new ArrayDeque<>();
  private Fix last;

  /** The way with the newest fix at its end. */
  Scene add(Fix fix, Scene.Up up) {
    boolean late = !isNewWay(fix) && last != null && fix.utime() <= last.utime();
    if (!late) append(fix);
    return scene(up);
  }

  private void append(Fix fix) {
    if (isNewWay(fix)) places.clear();
    last = fix;
    if (fix.pose() == null || (!places.isEmpty() && isNear(places.getLast(), fix))) return;
    places.addLast(fix);
    if (places.size() > LONGEST) places.removeFirst();
  }

  private boolean isNewWay(Fix fix) {
    return last != null && (fix.session() != last.session() || fix.origin() != last.origin()
        || fix.utime() < last.utime() - STEP_BACK);
  }

  private static boolean isNear(Fix one, Fix other) {
    double distance = Math.hypot(one.pose().x - other.pose().x, one.pose().y - other.pose().y);
    return one.certain() == other.certain() && distance < SPACING;
  }

  private Scene scene(Scene.Up up) {
    Scene scene = new Scene(up, last.summary());
    scene.shape(GUESS, way(false));
    scene.shape(WAY, way(true));
    if (!places.isEmpty()) {
      pose_t start = places.getFirst().pose();
      scene.mark(START, start.x, start.y);
    }
    if (last.covariance() != null) scene.shape(SPREAD, spread(last.pose(), last.covariance()));
    if (last.pose() != null)
      scene.arrow(last.certain() ? Robot.STYLE : GUESSED_ROBOT, last.pose().x, last.pose().y,
          last.pose().a);
    return scene;
  }

  /** The stretches that are certain, or those that are not. */
  private Path2D way(boolean certain) {
    Path2D path = new Path2D.Double();
    boolean open = false;
    for (Fix place : places) {
      if (place.certain() == certain) {
        if (open) path.lineTo(place.pose().x, place.pose().y);
        else path.moveTo(place.pose().x, place.pose().y);
      }
      open = place.certain() == certain;
    }
    if (open) path.lineTo(last.pose().x, last.pose().y);
    return path;
  }

  private static Shape spread(pose_t pose, double[] covariance) {
    double xx = covariance[0];
    double xy = covariance[1];
    double yy = covariance[4];
    double middle = (xx + yy) / 2;
    double half = Math.hypot((xx - yy) / 2, xy);
    double along = SIGMAS * Math.sqrt(middle + half);
    double across = SIGMAS * Math.sqrt(Math.max(0, middle - half));
    AffineTransform place = AffineTransform.getTranslateInstance(pose.x, pose.y);
    place.rotate(Math.atan2(2 * xy, xx - yy) / 2);
    return place.createTransformedShape(
        new Ellipse2D.Double(-along, -across, 2 * along, 2 * across));
  }
}
