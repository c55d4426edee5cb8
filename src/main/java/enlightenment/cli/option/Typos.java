package enlightenment.cli.option;

import enlightenment.text.Suggestion;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** Suggestions for options and commands that do not exist; picocli's own for options look at two letters only. */
public final class Typos {
    private Typos() {}

    /** A message for each option that does not exist, but none for their values; empty if something else is wrong. */
    public static List<String> unknownOptions(CommandLine.ParameterException e) {
        if (!(e instanceof CommandLine.UnmatchedArgumentException unmatched)) {
            return List.of();
        }
        List<String> names = options(e.getCommandLine().getCommandSpec());
        return unmatched.getUnmatched().stream()
                .filter(word -> word.startsWith("-"))
                .map(word -> "unknown option: '" + word + "'" + meant(word.replaceFirst("=.*", ""), names))
                .toList();
    }

    /** {@code ; did you mean ...?} for a command, or nothing if no name is near. */
    public static String command(String written, CommandLine root) {
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
