package enlightenment.cli.option;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A rule that options exclude others, or need one of them.
 *
 * @param options the options that the rule is about: the message names the first of these that was given
 * @param isNeed whether one of the others is needed; otherwise none of them may be given
 * @param others longest names, as all
 * @param excuse an option with which the rule does not hold; {@code ""} for none
 * @param message the message, with {@code %s} in place of the option
 */
public record OptionRule(List<String> options, boolean isNeed, List<String> others, String excuse, String message) {
    static OptionRule excludes(List<String> options, List<String> others, String message) {
        return new OptionRule(options, false, others, "", message);
    }

    static OptionRule needs(List<String> options, String other, String message) {
        return new OptionRule(options, true, List.of(other), "", message);
    }

    /** This rule, but not for command lines with this option. */
    OptionRule unless(String option) {
        return new OptionRule(options, isNeed, others, option, message);
    }

    /** The message if the options that were given break the rule; empty if they do not. */
    public Optional<String> broken(Set<String> given) {
        boolean hasOther = !Collections.disjoint(others, given);
        if (hasOther != isNeed && !given.contains(excuse)) {
            for (String option : options) {
                if (given.contains(option)) {
                    return Optional.of(message.formatted(option));
                }
            }
        }
        return Optional.empty();
    }
}
