package pico.spy;

import javax.swing.JComponent;

/** Shows what was decoded from messages; used on the Swing thread only. */
interface Display<T> {
  JComponent component();

  void show(T newest);

  /** What the status line says about it. */
  String summary(T newest);
}
