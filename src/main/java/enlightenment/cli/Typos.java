package enlightenment.cli;

import enlightenment.scene.json.Suggestion;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** What was meant by options and commands that there are not. picocli's own guesses for options look at two letters only. */
final class Typos {
    private Typos() {}

    /** {@code ; did you mean ...?}, or nothing where nothing is near. */
    static String suggestion(CommandLine.ParameterException e) {
        if (!(e instanceof CommandLine.UnmatchedArgumentException unmatched)
                || unmatched.getUnmatched().isEmpty()) {
            return "";
        }
        String written = unmatched.getUnmatched().get(0);
        return written.startsWith("-")
                ? meant(
                        written.replaceFirst("=.*", ""),
                        options(e.getCommandLine().getCommandSpec()))
                : command(written, e.getCommandLine());
    }

    /** The same for a command. */
    static String command(String written, CommandLine root) {
        return meant(written, new ArrayList<>(root.getSubcommands().keySet()));
    }

    private static List<String> options(CommandSpec command) {
        List<String> names = new ArrayList<>();
        for (OptionSpec option : command.options()) {
            if (!option.hidden()) {
                names.addAll(List.of(option.names()));
            }
        }
        return names;
    }

    private static String meant(String written, List<String> names) {
        String nearest = Suggestion.nearest(written, names);
        return nearest == null ? "" : "; did you mean \"" + nearest + "\"?";
    }
}
