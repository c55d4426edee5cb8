package enlightenment.cli;

import enlightenment.cli.film.AnimateCommand;
import enlightenment.cli.input.Failures;
import enlightenment.cli.measure.BenchCommand;
import enlightenment.cli.measure.CompareCommand;
import enlightenment.cli.measure.TradeCommand;
import enlightenment.cli.option.FilePath;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.option.Typos;
import enlightenment.cli.render.DevicesCommand;
import enlightenment.cli.render.MergeCommand;
import enlightenment.cli.render.RenderCommand;
import enlightenment.cli.scene.ConvertCommand;
import enlightenment.cli.scene.InspectCommand;
import enlightenment.cli.scene.NewCommand;
import enlightenment.cli.scene.SchemaCommand;
import enlightenment.cli.scene.ValidateCommand;
import enlightenment.cli.serve.ServerCommand;
import enlightenment.cli.serve.WorkerCommand;
import enlightenment.cli.store.RenderStoreCommand;
import enlightenment.cli.store.StoreExportCommand;
import enlightenment.cli.store.StoreInfoCommand;
import enlightenment.cli.terminal.Terminal;
import enlightenment.cli.view.ViewCommand;
import java.io.PrintWriter;
import java.nio.file.Path;
import picocli.AutoComplete;
import picocli.CommandLine;

/** All commands by name. */
final class Commands {
    static final String[] NAMES = {
        "render",
        "view",
        "animate",
        "new",
        "validate",
        "inspect",
        "schema",
        "convert",
        "compare",
        "trade",
        "bench",
        "merge",
        "devices",
        "render-store",
        "store-info",
        "store-export",
        "server",
        "worker",
        "setup"
    };

    private Commands() {}

    /** The command of this name, or null if it is none that can be made alone. */
    static Subcommand create(String name, Terminal terminal) {
        return switch (name) {
            case "render" -> new RenderCommand(terminal);
            case "view" -> new ViewCommand(terminal);
            case "animate" -> new AnimateCommand(terminal);
            case "new" -> new NewCommand(terminal);
            case "validate" -> new ValidateCommand(terminal);
            case "inspect" -> new InspectCommand(terminal);
            case "schema" -> new SchemaCommand(terminal);
            case "convert" -> new ConvertCommand(terminal);
            case "devices" -> new DevicesCommand(terminal);
            case "merge" -> new MergeCommand(terminal);
            case "render-store" -> new RenderStoreCommand(terminal);
            case "store-info" -> new StoreInfoCommand(terminal);
            case "store-export" -> new StoreExportCommand(terminal);
            case "server" -> new ServerCommand(terminal);
            case "worker" -> new WorkerCommand(terminal);
            case "compare" -> new CompareCommand(terminal);
            case "trade" -> new TradeCommand(terminal);
            case "bench" -> new BenchCommand(terminal);
            case "setup" -> new SetupCommand(terminal);
            default -> null;
        };
    }

    /** Configures a command line with the settings that all commands share. */
    static CommandLine configure(CommandLine line, Terminal terminal) {
        // A scene's name may begin with @.
        line.setExpandAtFiles(false);
        line.registerConverter(Path.class, new FilePath());
        line.setOut(new PrintWriter(terminal.out(), true));
        line.setErr(new PrintWriter(terminal.err(), true));
        OptionGroups.apply(line);
        line.getSubcommands().values().forEach(OptionGroups::apply);
        Failures failures = new Failures(terminal);
        return line.setParameterExceptionHandler(failures).setExecutionExceptionHandler(failures);
    }

    /** A command with the options of all methods. */
    private static CommandLine withAllMethods(Subcommand command) {
        CommandLine line = new CommandLine(command);
        command.methodOptions().ifPresent(options -> options.addOthers(line.getCommandSpec()));
        return line;
    }

    /** A command for these arguments: methods from outside are looked for where one is an option that ours do not explain. */
    static CommandLine line(Subcommand command, String[] arguments) {
        CommandLine line = new CommandLine(command);
        for (String argument : arguments) {
            int equals = argument.indexOf('=');
            String name = equals < 0 ? argument : argument.substring(0, equals);
            boolean help = name.equals("-h") || name.equals("--help");
            if (help
                    || name.startsWith("--")
                            && !line.getCommandSpec().optionsMap().containsKey(name)) {
                command.methodOptions().ifPresent(options -> options.addOthers(line.getCommandSpec()));
                return line;
            }
        }
        return line;
    }

    /** All commands, under the one that stands above them. */
    static CommandLine tree(Terminal terminal) {
        CommandLine tree = new CommandLine(new RootCommand());
        for (String name : NAMES) {
            tree.addSubcommand(name, withAllMethods(create(name, terminal)));
        }
        CommandLine completion = new CommandLine(new AutoComplete.GenerateCompletion());
        // Its own name, which its help shows, is another one.
        completion.setCommandName("completion");
        tree.addSubcommand("completion", completion);
        tree.addSubcommand("help", new CommandLine.HelpCommand());
        return configure(tree, terminal);
    }

    /** Help, completion, and everything that is wrong: these need to know all commands. */
    static int executeTree(String[] args, Terminal terminal) {
        CommandLine tree = tree(terminal);
        checkName(args, 0, tree);
        if (args.length > 0 && args[0].equals("help")) {
            checkName(args, 1, tree);
        }
        return tree.execute(args);
    }

    /** Fails if the word at this place is there and should be a command, but is none. */
    private static void checkName(String[] args, int at, CommandLine tree) {
        if (args.length > at
                && !args[at].startsWith("-")
                && !tree.getSubcommands().containsKey(args[at])) {
            throw new CommandLine.ParameterException(
                    tree, "unknown command \"" + args[at] + "\"" + Typos.command(args[at], tree));
        }
    }
}
