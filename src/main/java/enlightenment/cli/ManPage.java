package enlightenment.cli;

import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** The manual page enlightenment(1) in roff, made from picocli's model: what the help says, it says. */
final class ManPage {
    private static final String[][] ENVIRONMENT = {
        {"JAVA_HOME", "The Java to run with, 17 or newer; without it, java on the PATH."},
        {"JAVA_OPTS", "Options for Java, such as -Xmx8g, with blanks between them."},
        {"ENLIGHTENMENT_OPTS", "The same, for this program only; of two that contradict each other this one holds."},
        {"XDG_CACHE_HOME", "Where the class-data archive is kept, in the folder enlightenment; ~/.cache without it."}
    };
    private static final String[][] EXAMPLES = {
        {"enlightenment render scene.json -o picture.png", "Make a picture as the scene asks for it."},
        {
            "enlightenment render scene.json -o picture.png --method " + surveying() + " --error 0.005",
            "Make it with a root mean square error of at most 0.005."
        },
        {"enlightenment validate *.json", "Find all problems of some scenes."},
        {"source <(enlightenment completion)", "Let this bash or zsh complete commands, options and values."}
    };

    private final StringBuilder page = new StringBuilder();

    private ManPage() {}

    /** The method to give an error to: one that first looks where samples are needed. */
    private static Method surveying() {
        return BuiltInMethod.ALL.stream()
                .filter(m -> m.standIn().isPresent())
                .findFirst()
                .orElse(RenderSettings.Defaults.DEFAULT.method());
    }

    /** The page of the command with all its subcommands. */
    static String of(CommandLine tree, String version) {
        ManPage man = new ManPage();
        CommandSpec root = tree.getCommandSpec();
        man.header(root, version);
        man.line(".SH OPTIONS");
        man.arguments(root);
        man.line(".SH COMMANDS");
        for (Map.Entry<String, CommandLine> command : tree.getSubcommands().entrySet()) {
            man.command(command.getKey(), command.getValue().getCommandSpec());
        }
        man.exitStatus();
        man.terms("ENVIRONMENT", ENVIRONMENT);
        man.terms("EXAMPLES", EXAMPLES);
        return man.page.toString();
    }

    private void header(CommandSpec root, String version) {
        line(".TH ENLIGHTENMENT 1 \"\" \"Enlightenment " + text(version) + "\" \"User Commands\"");
        // No hyphens at the ends of lines, nor blanks between words to fill them: both spoil options.
        line(".nh");
        line(".ad l");
        line(".SH NAME");
        String does = String.join(" ", root.usageMessage().description());
        line("enlightenment \\- " + text(does.replaceFirst("\\.$", "").toLowerCase(Locale.ROOT)));
        line(".SH SYNOPSIS");
        line(".B enlightenment");
        line("\\fICOMMAND\\fR [\\fIOPTION\\fR...] [\\fIARGUMENT\\fR...]");
    }

    private void command(String name, CommandSpec spec) {
        line(".SS enlightenment " + text(synopsis(name, spec)));
        for (String paragraph : spec.usageMessage().description()) {
            sentence(paragraph);
        }
        arguments(spec);
    }

    /** The command with what must be given, and "[options]" where more may be. */
    private static String synopsis(String name, CommandSpec spec) {
        List<String> words = new ArrayList<>(List.of(name));
        for (PositionalParamSpec parameter : visible(spec.positionalParameters())) {
            String repeated = parameter.arity().max() > 1 ? "..." : "";
            String word = parameter.paramLabel() + repeated;
            words.add(parameter.required() ? word : "[" + word + "]");
        }
        boolean more = false;
        for (OptionSpec option : visible(spec.options())) {
            if (option.required()) {
                words.add(option.shortestName() + " " + option.paramLabel());
            }
            more |= !option.required() && !option.usageHelp();
        }
        if (more) {
            words.add("[options]");
        }
        return String.join(" ", words);
    }

    private void arguments(CommandSpec spec) {
        for (PositionalParamSpec parameter : visible(spec.positionalParameters())) {
            line(".TP");
            line("\\fI" + text(parameter.paramLabel()) + "\\fR");
            description(parameter);
        }
        for (OptionSpec option : visible(spec.options())) {
            line(".TP");
            List<String> names = new ArrayList<>();
            for (String name : option.names()) {
                names.add("\\fB" + text(name) + "\\fR");
            }
            String value = "\\fI" + text(option.paramLabel()) + "\\fR";
            boolean mayHave = option.arity().max() > 0;
            boolean mustHave = option.arity().min() > 0;
            line(String.join(", ", names) + (mustHave ? " " + value : mayHave ? " [" + value + "]" : ""));
            description(option);
        }
    }

    private void description(ArgSpec argument) {
        for (String paragraph : argument.description()) {
            sentence(paragraph);
        }
    }

    private void exitStatus() {
        terms("EXIT STATUS", new String[][] {
            {"0", "Done."},
            {"1", "Failed: what was asked for is sound, but could not be done or kept."},
            {"2", "Wrong usage, or a scene or picture that cannot be used."}
        });
    }

    private void terms(String title, String[][] terms) {
        line(".SH " + title);
        for (String[] term : terms) {
            line(".TP");
            line("\\fB" + text(term[0]) + "\\fR");
            sentence(term[1]);
        }
    }

    private static <A extends ArgSpec> List<A> visible(List<A> all) {
        return all.stream().filter(a -> !a.hidden()).toList();
    }

    private void sentence(String said) {
        String escaped = text(said);
        // A line that begins like this would be taken for a request.
        line(escaped.startsWith(".") || escaped.startsWith("'") ? "\\&" + escaped : escaped);
    }

    /** With everything that roff would take for its own escaped. */
    private static String text(String plain) {
        return plain.replace("\\", "\\e").replace("-", "\\-").replace("~", "\\(ti");
    }

    private void line(String roff) {
        page.append(roff).append('\n');
    }
}
