package pico.spy;

import java.awt.event.ActionEvent;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.JDesktopPane;
import lcm.spy.ChannelData;

/**
 * What a plugin gives to lcm-spy: the name of a view for the menu, and, once chosen, the view. For
 * the name lcm-spy asks without a desktop and a channel.
 */
final class OpenView<T> extends AbstractAction {
  private final String name;
  private final transient JDesktopPane desktop;
  private final transient ChannelData channel;
  private final transient Decoder<T> decoder;
  private final transient Supplier<Display<T>> display;

  OpenView(String name, JDesktopPane desktop, ChannelData channel, Decoder<T> decoder,
      Supplier<Display<T>> display) {
    super(name);
    this.name = name;
    this.desktop = desktop;
    this.channel = channel;
    this.decoder = decoder;
    this.display = display;
  }

  @Override
  public void actionPerformed(ActionEvent event) {
    new View<>(name, channel, decoder, display.get()).open(desktop);
  }
}
