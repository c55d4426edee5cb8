package enlightenment.cli;

import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.MethodSetting;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.ISetter;
import picocli.CommandLine.Model.OptionSpec;

/** The options for settings that only some methods look at: one for each that the registry of methods tells of. */
final class MethodOptions {
    private final Map<MethodSetting, Object> values = new LinkedHashMap<>();
    private final CommandSpec spec = CommandSpec.create();

    MethodOptions() {
        for (MethodSetting setting : Method.settings(BuiltInMethod.ALL)) {
            spec.addOption(option(setting));
        }
    }

    /** The options of our own methods, to be mixed into a command. */
    CommandSpec spec() {
        return spec;
    }

    /** Adds the options of methods from outside to the command into which the others were mixed. */
    void addOthers(CommandSpec command) {
        for (MethodSetting setting : Method.settings(Method.all())) {
            if (!command.optionsMap().containsKey(setting.option())) {
                command.addOption(option(setting));
            }
        }
    }

    /** The same settings with those that were given. */
    RenderSettings applied(RenderSettings settings) {
        RenderSettings s = settings;
        for (Map.Entry<MethodSetting, Object> given : values.entrySet()) {
            s = s.with(given.getKey(), given.getValue());
        }
        return s;
    }

    /** The options that were given, word by word. */
    List<String> given() {
        List<String> words = new ArrayList<>();
        values.forEach((setting, value) -> words.addAll(List.of(setting.option(), value.toString())));
        return words;
    }

    private OptionSpec option(MethodSetting setting) {
        OptionSpec.Builder option = OptionSpec.builder(setting.option()).setter(new Setter(setting));
        if (setting instanceof MethodSetting.Whole whole) {
            return option.paramLabel("N")
                    .type(Integer.class)
                    .converters(new Number(whole))
                    .description(setting.description() + ", " + setting.range())
                    .build();
        }
        Words words = new Words(((MethodSetting.Word) setting).words());
        return option.paramLabel("KIND")
                .type(String.class)
                .converters(words)
                .completionCandidates(words)
                .description(setting.description() + ": " + setting.range())
                .build();
    }

    private final class Setter implements ISetter {
        private final MethodSetting setting;

        Setter(MethodSetting setting) {
            this.setting = setting;
        }

        @Override
        @SuppressWarnings("unchecked") // picocli's T is whatever was set before
        public <T> T set(T value) {
            return (T) (value == null ? values.remove(setting) : values.put(setting, value));
        }
    }

    private static final class Number extends WholeNumber {
        Number(MethodSetting.Whole setting) {
            super(setting.min(), setting.max());
        }
    }

    private static final class Words extends WordOption<String> {
        Words(List<String> words) {
            super(words);
        }
    }
}
