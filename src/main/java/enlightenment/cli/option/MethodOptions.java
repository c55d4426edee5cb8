package enlightenment.cli.option;

import enlightenment.math.InvalidValueException;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.ISetter;
import picocli.CommandLine.Model.OptionSpec;

/** The options for settings of some methods or of all: one for each that the registry of methods tells of. */
public final class MethodOptions {
    private final List<Setter> setters = new ArrayList<>();
    private final CommandSpec spec = CommandSpec.create();

    public MethodOptions() {
        for (Method.Setting setting : Method.settings(BuiltInMethod.ALL)) {
            spec.addOption(option(setting));
        }
    }

    /** The options of our own methods, to be mixed into a command. */
    public CommandSpec spec() {
        return spec;
    }

    /** Adds the options of methods from outside to the command into which the others were mixed. */
    public void addOthers(CommandSpec command) {
        for (Method.Setting setting : Method.settings(Method.all())) {
            if (!command.optionsMap().containsKey(setting.option())) {
                command.addOption(option(setting));
            }
        }
    }

    /** The settings with the values of the options that were given. */
    public RenderSettings applied(RenderSettings settings) {
        RenderSettings s = settings;
        for (Setter option : setters) {
            s = option.value == null ? s : s.with(option.setting, option.value);
        }
        return s;
    }

    /** The options that were given, word by word. */
    public List<String> given() {
        List<String> words = new ArrayList<>();
        for (Setter option : setters) {
            if (option.value != null) {
                words.addAll(List.of(option.setting.option(), option.value.toString()));
            }
        }
        return words;
    }

    private OptionSpec option(Method.Setting setting) {
        Setter setter = new Setter(setting);
        setters.add(setter);
        OptionSpec.Builder option = OptionSpec.builder(setting.option()).setter(setter);
        if (setting instanceof Method.Setting.Whole whole) {
            return option.paramLabel("N")
                    .type(Long.class)
                    .converters(new Number(whole))
                    .description(setting.description() + ", " + setting.range())
                    .build();
        }
        Words words = new Words(((Method.Setting.Word) setting).words());
        return option.paramLabel("KIND")
                .type(String.class)
                .converters(words)
                .completionCandidates(words)
                .description(setting.description() + ": " + setting.range())
                .build();
    }

    /** Holds the value of one option. */
    private static final class Setter implements ISetter {
        private final Method.Setting setting;
        private Object value;

        Setter(Method.Setting setting) {
            this.setting = setting;
        }

        @Override
        @SuppressWarnings("unchecked") // picocli's T is whatever was set before
        public <T> T set(T now) {
            T before = (T) value;
            value = now;
            return before;
        }
    }

    private record Number(Method.Setting.Whole setting) implements ITypeConverter<Long> {
        @Override
        public Long convert(String text) {
            try {
                return setting.checked(Long.valueOf(text));
            } catch (NumberFormatException | InvalidValueException e) {
                throw BadValue.expected("a whole number in " + setting.limits(), text);
            }
        }
    }

    private static final class Words extends WordOption<String> {
        Words(List<String> words) {
            super(words);
        }
    }
}
