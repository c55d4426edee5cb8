package enlightenment.cli;

import enlightenment.cli.render.RenderCommand;
import enlightenment.scene.ChosenSettings;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Layout;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** Shows the options of {@code render} in groups, the most common ones first: forty in one list hide those that everybody needs. */
final class OptionGroups {
    private static final Map<String, List<String>> RENDER = new LinkedHashMap<>();

    static {
        RENDER.put(
                "Common",
                List.of(
                        "--output",
                        "--size",
                        "--samples",
                        "--error",
                        "--time",
                        "--method",
                        "--exposure",
                        "--preview",
                        "--threads",
                        "--help"));
        List<String> picture = new ArrayList<>(List.of("--crop", "--frame", "--antialias"));
        ChosenSettings.Common.ALL.forEach(setting -> picture.add(setting.option()));
        RENDER.put("Picture", picture);
        RENDER.put("Method", List.of("--shadow-samples", "--proposal", "--large-steps", "--mutations"));
        RENDER.put(
                "Output",
                List.of(
                        "--format",
                        "--depth",
                        "--report",
                        "--stats",
                        "--aov",
                        "--denoised",
                        "--dump-clusters",
                        "--dump-chains"));
        RENDER.put(
                "Files of other programs",
                List.of("--camera", "--view", "--up", "--background", "--fps", "--animation", "--assets"));
        RENDER.put("Watching", List.of("--serve", "--window", "--progress"));
        RENDER.put(
                "Keeping",
                List.of(
                        "--checkpoint",
                        "--resume",
                        "--store",
                        "--store-user",
                        "--store-password-file",
                        "--store-samples",
                        "--store-rays"));
        RENDER.put("Many machines, other devices", List.of("--part", "--device"));
    }

    /** For options of methods from outside, which are in no group. */
    private static final String OTHERS = "Further methods";

    private OptionGroups() {}

    /** Groups the options in the help of {@code render}; other commands have few options. */
    static void apply(CommandLine line) {
        if (line.getCommand() instanceof RenderCommand) {
            line.getHelpSectionMap().put(UsageMessageSpec.SECTION_KEY_OPTION_LIST, OptionGroups::list);
        }
    }

    /** The names of all options that are in a group. */
    static List<String> grouped() {
        return RENDER.values().stream().flatMap(List::stream).toList();
    }

    private static String list(Help help) {
        List<OptionSpec> left = new ArrayList<>(help.commandSpec().options());
        left.removeIf(OptionSpec::hidden);
        StringBuilder text = new StringBuilder();
        RENDER.forEach((heading, names) -> {
            List<OptionSpec> members = new ArrayList<>();
            for (String name : names) {
                OptionSpec option = help.commandSpec().findOption(name);
                if (option != null && left.remove(option)) {
                    members.add(option);
                }
            }
            append(heading, members, help, text);
        });
        append(OTHERS, left, help, text);
        return text.toString();
    }

    private static void append(String heading, List<OptionSpec> members, Help help, StringBuilder text) {
        if (members.isEmpty()) {
            return;
        }
        Layout layout = help.createDefaultLayout();
        layout.addOptions(members, help.createDefaultParamLabelRenderer());
        text.append(System.lineSeparator())
                .append(heading)
                .append(':')
                .append(System.lineSeparator())
                .append(layout);
    }
}
