package pico.spy;

import java.io.IOException;
import lcm.lcm.LCMDataInputStream;

/** From a message's bytes to what a display shows; null where more messages have to come first. */
@FunctionalInterface
interface Decoder<T> {
  T decode(LCMDataInputStream bytes) throws IOException;
}
