package pico.spy;

import java.awt.geom.Path2D;
import java.util.Arrays;
import java.util.List;
import pico.map_object_t;
import pico.map_point_t;
import pico.map_t;
import pico.pose_t;

/** What a map looks like. Indices that point nowhere are left out. */
final class MapScene {
  private final Scene scene;

  private MapScene(Scene scene) {
    this.scene = scene;
  }

  /** Of all parts of one map. */
  static Scene of(List<map_t> parts) {
    map_t first = parts.get(0);
    Scene.Up up = first.frame.equals("world") ? Scene.Up.Y : Scene.Up.X;
    MapScene drawn = new MapScene(new Scene(up, summary(parts)));
    for (map_t part : parts) drawn.addObjects(part);
    for (map_t part : parts) drawn.addCorners(part);
    drawn.addRobot(first);
    return drawn.scene;
  }

  private static String summary(List<map_t> parts) {
    map_t first = parts.get(0);
    String text = Text.of("map %d in the %s frame", first.seq, first.frame);
    text += ": " + Text.count(count(parts, map_object_t.WALL), "wall");
    text += ", " + Text.count(count(parts, map_object_t.DOOR), "door");
    text += ", " + Text.count(count(parts, map_object_t.POSSIBLE_DOOR), "possible door");
    if (parts.size() > 1) text += Text.of(", in %d parts", parts.size());
    if (first.unobservable) text += "; one direction is known by odometry alone";
    return text;
  }

  private static long count(List<map_t> parts, byte type) {
    return parts.stream()
        .flatMap(part -> Arrays.stream(part.objects))
        .filter(object -> object.type == type)
        .count();
  }

  private void addObjects(map_t map) {
    for (map_object_t object : map.objects) {
      List<map_point_t> points = pointsOf(map, object);
      Style style = MapStyles.of(object);
      if (object.draw_type == map_object_t.DRAW_POINTS || points.size() == 1) {
        for (map_point_t point : points) addPoint(style, point);
      } else if (points.size() > 1) {
        scene.shape(style, outline(points, object.connection == map_object_t.CLOSED),
            text(object));
      }
    }
  }

  private static String text(map_object_t object) {
    String text = Text.of("%s, id %d, weight %.1f", object.name, object.id, object.weight);
    if (object.support > 0) text += ", " + Text.count(object.support, "beam");
    if (object.confidence > 0) text += Text.of(", confidence %.2f", object.confidence);
    return object.reason.isEmpty() ? text : text + ": " + object.reason;
  }

  private void addPoint(Style style, map_point_t point) {
    scene.mark(style.isMark() ? style : MapStyles.POINT, point.x, point.y);
  }

  private static List<map_point_t> pointsOf(map_t map, map_object_t object) {
    return Arrays.stream(object.points)
        .filter(index -> index >= 0 && index < map.num_points)
        .mapToObj(index -> map.points[index])
        .toList();
  }

  private static Path2D outline(List<map_point_t> points, boolean closed) {
    Path2D path = new Path2D.Double();
    path.moveTo(points.get(0).x, points.get(0).y);
    for (map_point_t point : points.subList(1, points.size())) path.lineTo(point.x, point.y);
    if (closed) path.closePath();
    return path;
  }

  private void addCorners(map_t map) {
    for (map_point_t point : map.points) {
      if (isCorner(map, point)) scene.mark(MapStyles.of(point), point.x, point.y);
    }
  }

  /** The end of a wall, or a lone corner; not a point of an outline. */
  private static boolean isCorner(map_t map, map_point_t point) {
    return point.num_parents == 0
        || Arrays.stream(point.parents)
            .filter(index -> index >= 0 && index < map.num_objects)
            .anyMatch(index -> map.objects[index].type == map_object_t.WALL);
  }

  private void addRobot(map_t map) {
    pose_t robot = switch (map.frame) {
      case "robot" -> new pose_t();
      case "zero" -> map.robot_in_zero;
      case "local" -> map.robot_in_local;
      default -> null;
    };
    if (robot != null) Robot.add(scene, robot.x, robot.y, robot.a);
  }
}
