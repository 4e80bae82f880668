package pico.spy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import pico.map_t;

/** Collects the parts of a map that was too large for one message. */
final class MapParts {
  private final Map<Integer, map_t> parts = new TreeMap<>();
  private long session;
  private long id;
  private int expected;

  /** All parts of the map, in order; empty while some are missing. */
  List<map_t> add(map_t part) {
    if (part.session != session || part.map_id != id || part.parts != expected) parts.clear();
    session = part.session;
    id = part.map_id;
    expected = part.parts;
    parts.put(part.part, part);
    return parts.size() < expected ? List.of() : new ArrayList<>(parts.values());
  }
}
