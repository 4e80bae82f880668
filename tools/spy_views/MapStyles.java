package pico.spy;

import java.util.List;
import pico.map_object_t;
import pico.map_point_t;

/** How the objects and points of a map look. */
final class MapStyles {
  private static final Style WALL = Style.line("wall", Palette.BLACK, 2.5, Dash.NONE);
  private static final Style UNSEEN =
      Style.line("not seen yet", Palette.SKY_BLUE, 2.5, Dash.DASHES);
  private static final Style CONTRADICTED =
      Style.line("is not there", Palette.VERMILION, 2.5, Dash.DOTS);
  private static final Style CABINET =
      Style.area("cabinet", Palette.BLUE, 2, Dash.NONE, Fill.HATCH);
  private static final Style DOOR = Style.line("door", Palette.GREEN, 5, Dash.NONE);
  private static final Style SHUT_DOOR = Style.line("door, shut", Palette.PURPLE, 5, Dash.NONE);
  private static final Style POSSIBLE_DOOR =
      Style.line("possible door", Palette.GREEN, 3, Dash.DASHES);
  private static final Style STATIC_OBSTACLE =
      Style.area("obstacle, stands", Palette.VERMILION, 2, Dash.NONE, Fill.TINT);
  private static final Style DYNAMIC_OBSTACLE =
      Style.area("obstacle, moves", Palette.PURPLE, 2, Dash.DASHES, Fill.TINT);
  private static final Style START_AREA =
      Style.area("start area", Palette.SKY_BLUE, 1.5, Dash.DASHES_DOTS, Fill.TINT);
  private static final Style SAFE_DISTANCE =
      Style.line("safe distance", Palette.ORANGE, 2, Dash.DASHES);
  private static final Style FOOTPRINT = Style.line("robot's base", Palette.BLACK, 1, Dash.NONE);
  private static final Style ORIGIN = Style.mark("origin", Palette.BLACK, Mark.CROSS);
  static final Style POINT = Style.mark("point", Palette.PURPLE, Mark.DIAMOND);
  private static final Style OTHER = Style.line("other", Palette.ORANGE, 1.5, Dash.DASHES_DOTS);

  private static final Style FLOATING = Style.mark("loose end", Palette.DARK_GREY, Mark.RING);
  private static final Style CONNECTED = Style.mark("corner", Palette.BLACK, Mark.DISC);
  private static final Style CONVEX =
      Style.mark("convex corner", Palette.VERMILION, Mark.TRIANGLE);
  private static final Style CONCAVE = Style.mark("concave corner", Palette.BLUE, Mark.SQUARE);

  static final List<Style> LEGEND = List.of(WALL, UNSEEN, CONTRADICTED, CONVEX, CONCAVE, CONNECTED,
      FLOATING, DOOR, SHUT_DOOR, POSSIBLE_DOOR, CABINET, STATIC_OBSTACLE, DYNAMIC_OBSTACLE,
      START_AREA, SAFE_DISTANCE, FOOTPRINT, Robot.STYLE, ORIGIN, POINT, OTHER);

  private MapStyles() {}

  static Style of(map_object_t object) {
    return switch (object.type) {
      case map_object_t.WALL -> found(object, WALL);
      case map_object_t.CABINET -> found(object, CABINET);
      case map_object_t.DOOR -> found(object, DOOR);
      case map_object_t.POSSIBLE_DOOR -> POSSIBLE_DOOR;
      case map_object_t.STATIC_OBSTACLE -> STATIC_OBSTACLE;
      case map_object_t.DYNAMIC_OBSTACLE -> DYNAMIC_OBSTACLE;
      case map_object_t.START_AREA -> START_AREA;
      case map_object_t.SAFE_DISTANCE -> SAFE_DISTANCE;
      case map_object_t.ROBOT -> FOOTPRINT;
      case map_object_t.ORIGIN -> ORIGIN;
      default -> OTHER;
    };
  }

  static Style of(map_point_t point) {
    return switch (point.property) {
      case map_point_t.CONVEX -> CONVEX;
      case map_point_t.CONCAVE -> CONCAVE;
      case map_point_t.CONNECTED -> CONNECTED;
      default -> FLOATING;
    };
  }

  /** COMBINED_MAP says by the reason what became of a thing of the known building. */
  private static Style found(map_object_t object, Style otherwise) {
    return switch (object.reason) {
      case "unseen" -> UNSEEN;
      case "contradicted" -> CONTRADICTED;
      case "shut" -> SHUT_DOOR;
      default -> otherwise;
    };
  }
}
