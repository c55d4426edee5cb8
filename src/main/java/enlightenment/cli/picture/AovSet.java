package enlightenment.cli.picture;

import enlightenment.cli.option.BadValue;
import enlightenment.cli.option.WordOption;
import enlightenment.cli.terminal.CliException;
import enlightenment.render.RenderResult;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import picocli.CommandLine.ITypeConverter;

/** The further pictures that are asked for beside the picture, in the order of {@link RenderResult.Auxiliary}. */
public record AovSet(Set<RenderResult.Auxiliary> kinds) {
    public static final AovSet EMPTY = new AovSet(Set.of());

    /** Fails for what a scene's shading does not have. */
    public void check(Scene scene) {
        List<String> words = kinds.stream()
                .filter(RenderResult.Auxiliary::needsPaths)
                .map(RenderResult.Auxiliary::word)
                .toList();
        if (!words.isEmpty() && !(scene.shading() instanceof Shading.Physical)) {
            throw CliException.wrongUsage("--aov " + String.join(",", words)
                    + " is for physical shading: classic shading does not tell it apart");
        }
    }

    /** As it is typed. picocli asks for it at each start, and Java would take longer to make a record's own. */
    @Override
    public String toString() {
        List<String> words = new ArrayList<>();
        kinds.forEach(kind -> words.add(kind.word()));
        return String.join(",", words);
    }

    /** Reads words with commas between them. */
    public static final class Converter implements ITypeConverter<AovSet> {
        @Override
        public AovSet convert(String text) {
            Words words = new Words();
            Set<RenderResult.Auxiliary> kinds = EnumSet.noneOf(RenderResult.Auxiliary.class);
            for (String word : text.split(",", -1)) {
                if (!kinds.add(words.convert(word))) {
                    throw new BadValue("names " + word + " twice");
                }
            }
            return new AovSet(Collections.unmodifiableSet(kinds));
        }
    }

    /** One of the words. */
    public static final class Words extends WordOption<RenderResult.Auxiliary> {
        Words() {
            super(List.of(RenderResult.Auxiliary.values()));
        }

        @Override
        protected String word(RenderResult.Auxiliary kind) {
            return kind.word();
        }
    }
}
