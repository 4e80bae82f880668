package pico.spy;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Locale;

/** Numbers for people: a point and no group separators, whatever the machine's language is. */
final class Text {
  private Text() {}

  static String of(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }

  /** A number that prints with so many decimals. */
  static Number rounded(double value, int decimals) {
    if (!Double.isFinite(value)) return value;
    return BigDecimal.valueOf(value).setScale(decimals, RoundingMode.HALF_UP);
  }

  /** "1 wall", "2 walls" */
  static String count(long number, String noun) {
    return number + " " + noun + (number == 1 ? "" : "s");
  }
}
