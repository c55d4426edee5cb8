package enlightenment.json;

import java.io.StringWriter;
import java.util.Locale;
import java.util.function.Consumer;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.PrettyPrinter;
import tools.jackson.core.StreamWriteFeature;
import tools.jackson.core.io.JsonStringEncoder;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.util.DefaultIndenter;
import tools.jackson.core.util.DefaultPrettyPrinter;
import tools.jackson.core.util.JsonGeneratorDelegate;
import tools.jackson.core.util.Separators;

/**
 * JSON texts (RFC 8259), indented by two spaces, with a line feed at the end. Doubles are written as {@link Double#toString}
 * writes them, so that they are read back exactly; JSON has no numbers that are not finite: they become {@code null}.
 */
public final class JsonText {
    private static final JsonFactory FACTORY = JsonFactory.builder()
            // The shortest digits differ from those of Double.toString before Java 19.
            .disable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER)
            // What is left open is a mistake of the program: it must not be closed in silence.
            .disable(StreamWriteFeature.AUTO_CLOSE_CONTENT)
            .build();

    private JsonText() {}

    /**
     * The text of one value.
     *
     * @param content writes the value, and ends every object and array that it starts
     * @throws IllegalStateException if one is not ended
     */
    public static String of(Consumer<JsonGenerator> content) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = new Generator(FACTORY.createGenerator(new Indented(), text))) {
            content.accept(json);
            if (!json.streamWriteContext().inRoot()) {
                throw new IllegalStateException("an object or array is not ended");
            }
        }
        return text.append('\n').toString();
    }

    /** A text as a JSON string, with its quotation marks and without a line feed at the end. */
    public static String quoted(String text) {
        return of(json -> json.writeString(text)).strip();
    }

    /** Asks for {@code "key": value}, one in a line. */
    private static final class Indented extends ObjectWriteContext.Base {
        private static final DefaultIndenter INDENTER = new DefaultIndenter("  ", "\n");

        @Override
        public boolean hasPrettyPrinter() {
            return true;
        }

        @Override
        public PrettyPrinter getPrettyPrinter() {
            Separators separators = Separators.createDefaultInstance()
                    .withObjectNameValueSpacing(Separators.Spacing.AFTER)
                    .withObjectEmptySeparator("")
                    .withArrayEmptySeparator("");
            return new DefaultPrettyPrinter(separators)
                    .withObjectIndenter(INDENTER)
                    .withArrayIndenter(INDENTER);
        }
    }

    /** Jackson's generator, which would write {@code "NaN"} as a string, and half a character as it is. */
    private static final class Generator extends JsonGeneratorDelegate {
        Generator(JsonGenerator json) {
            super(json);
        }

        @Override
        public JsonGenerator writeNumber(double value) {
            return Double.isFinite(value) ? super.writeNumber(value) : writeNull();
        }

        @Override
        public JsonGenerator writeNumber(float value) {
            return Float.isFinite(value) ? super.writeNumber(value) : writeNull();
        }

        @Override
        public JsonGenerator writeString(String value) {
            return value == null || isWellFormed(value)
                    ? super.writeString(value)
                    : writeRawValue('"' + escaped(value) + '"');
        }

        /** Whether UTF-8 can encode it: a surrogate without its other half cannot be. */
        private static boolean isWellFormed(String text) {
            return text.codePoints().noneMatch(Generator::isSurrogate);
        }

        private static boolean isSurrogate(int codePoint) {
            return codePoint >= Character.MIN_SURROGATE && codePoint <= Character.MAX_SURROGATE;
        }

        private static String escaped(String text) {
            StringBuilder out = new StringBuilder();
            text.codePoints()
                    .forEach(c -> out.append(
                            isSurrogate(c)
                                    ? String.format(Locale.ROOT, "\\u%04x", c)
                                    : new String(
                                            JsonStringEncoder.getInstance().quoteAsCharArray(Character.toString(c)))));
            return out.toString();
        }
    }
}
