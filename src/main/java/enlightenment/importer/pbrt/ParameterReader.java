package enlightenment.importer.pbrt;

import enlightenment.text.Plain;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Reads lists of parameters. */
final class ParameterReader {
    private static final int MOST_WORDS = 1_000_000;

    private static final Set<String> TYPES = Set.of(
            "float",
            "integer",
            "point",
            "point2",
            "point3",
            "vector",
            "vector2",
            "vector3",
            "normal",
            "normal3",
            "rgb",
            "spectrum",
            "blackbody",
            "bool",
            "string",
            "texture");

    private ParameterReader() {}

    /** Reads all parameters that follow. */
    static Parameters read(TokenSource in) throws IOException {
        Parameters all = new Parameters(in.place());
        for (Token t = in.peek(); t != null && t.kind() == Token.Kind.STRING; t = in.peek()) {
            all.add(parameter(in));
        }
        return all;
    }

    private static Parameter parameter(TokenSource in) throws IOException {
        Token declaration = in.next();
        String[] words = declaration.text().strip().split("\\s+");
        if (words.length != 2 || !TYPES.contains(words[0])) {
            throw declaration
                    .place()
                    .failure("expected a parameter, \"type name\" with one of pbrt-v4's types, not "
                            + Plain.quoted(declaration.text()));
        }
        Token first = in.peek();
        Numbers numbers = new Numbers();
        List<String> strings = new ArrayList<>();
        if (first != null && first.kind() == Token.Kind.OPEN) {
            in.next();
            list(in, declaration, numbers, strings);
        } else if (first == null || first.kind() == Token.Kind.CLOSE) {
            throw declaration.place().failure("the parameter " + Plain.quoted(declaration.text()) + " has no value");
        } else {
            value(in.next(), numbers, strings);
        }
        if (numbers.size() > 0 && !strings.isEmpty()) {
            throw declaration
                    .place()
                    .failure("the parameter " + Plain.quoted(declaration.text()) + " has both numbers and words");
        }
        return new Parameter(words[0], words[1], numbers.toArray(), List.copyOf(strings), declaration.place());
    }

    private static void list(TokenSource in, Token declaration, Numbers numbers, List<String> strings)
            throws IOException {
        while (true) {
            Token t = in.next();
            if (t == null || t.kind() == Token.Kind.OPEN) {
                throw declaration
                        .place()
                        .failure("the list of " + Plain.quoted(declaration.text()) + " has no closing bracket");
            }
            if (t.kind() == Token.Kind.CLOSE) {
                return;
            }
            value(t, numbers, strings);
        }
    }

    private static void value(Token t, Numbers numbers, List<String> strings) {
        if (t.kind() == Token.Kind.STRING || t.text().equals("true") || t.text().equals("false")) {
            if (strings.size() == MOST_WORDS) {
                throw t.place().failure("a list has more than " + MOST_WORDS + " strings");
            }
            strings.add(t.text());
        } else if (!numbers.add(TokenSource.number(t, "a number, a string, true or false"))) {
            throw t.place().failure("a list has more than " + Numbers.MOST + " numbers");
        }
    }
}
