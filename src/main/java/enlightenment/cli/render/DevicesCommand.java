package enlightenment.cli.render;

import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.device.ComputeDevice;
import enlightenment.device.DeviceFailure;
import enlightenment.device.opencl.OpenClDevices;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Command;

/** {@code enlightenment devices}: lists what {@code --device} can name. */
@Command(
        name = "devices",
        description = "Lists the devices that can take part in a render, with memory and speed in double precision.")
public final class DevicesCommand extends Subcommand {
    private static final double GIGA = 1e9;

    public DevicesCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() {
        print("cpu", Runtime.getRuntime().availableProcessors() + " threads, always there");
        try {
            List<ComputeDevice> all = OpenClDevices.all();
            for (int k = 0; k < all.size(); k++) {
                print("opencl:" + k, line(all.get(k)));
            }
        } catch (DeviceFailure e) {
            terminal.say(e.getMessage());
        }
        return ExitCode.DONE;
    }

    private void print(String word, String text) {
        terminal.out().printf(Locale.ROOT, "%-10s %s%n", word, text);
    }

    private static String line(ComputeDevice device) {
        String known =
                String.format(Locale.ROOT, "%s, %.1f GB, %s, ", device.name(), device.memory() / GIGA, device.speed());
        if (!device.problem().isEmpty()) {
            return known + "cannot be used: " + device.problem();
        }
        try {
            return known
                    + String.format(
                            Locale.ROOT,
                            "%.0f billion operations in double precision in a second",
                            device.measureDoubleRate() / GIGA);
        } catch (DeviceFailure e) {
            return known + "cannot be used: " + e.getMessage();
        }
    }
}
