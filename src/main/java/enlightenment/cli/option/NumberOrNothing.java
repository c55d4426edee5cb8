package enlightenment.cli.option;

import java.util.Map;
import java.util.Stack;
import picocli.CommandLine.IParameterPreprocessor;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;

/** For an option whose number may be left out: takes the next argument only if it is a number, since what is none may be the scene. */
public abstract class NumberOrNothing implements IParameterPreprocessor {
    private final String value;

    /** @param value what is meant where no number is given */
    public NumberOrNothing(String value) {
        this.value = value;
    }

    @Override
    public boolean preprocess(Stack<String> args, CommandSpec command, ArgSpec option, Map<String, Object> info) {
        boolean isAttached = info.get("separator") != null && !" ".equals(info.get("separator"));
        // A negative number is no option, and is refused as a number.
        if (!isAttached && (args.isEmpty() || !args.peek().matches("-?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?"))) {
            args.push(value);
        }
        return false;
    }
}
