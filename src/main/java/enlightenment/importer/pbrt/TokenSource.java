package enlightenment.importer.pbrt;

import enlightenment.importer.support.InputFolder;
import enlightenment.scene.SceneException;
import enlightenment.text.Plain;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Iterator;
import java.util.Locale;
import java.util.Set;

/** The tokens of a file and of those that it includes, in one sequence. */
final class TokenSource implements Closeable {
    /** The deepest chain of included files. */
    private static final int DEEPEST = 32;

    /** The most that is read of all files together, in characters: files that include others many times multiply. */
    private static final long LARGEST = 1L << 32;

    private final InputFolder folder;
    private final Deque<Lexer> open = new ArrayDeque<>();

    /** Those of the open files whose end is a token. */
    private final Set<Lexer> imported = new HashSet<>();

    private Token peeked;
    private Place last;
    private long closedCharacters;

    TokenSource(InputFolder folder) throws IOException {
        Path file = folder.imported();
        this.folder = folder;
        open.push(new Lexer(file, true));
        last = new Place(file, 1, true);
    }

    /** The folder that files must lie in. */
    InputFolder folder() {
        return folder;
    }

    /** Where the last token stood. */
    Place place() {
        return last;
    }

    /** The next token, which stays the next one; null at the end. */
    Token peek() throws IOException {
        if (peeked == null) {
            peeked = read();
        }
        return peeked;
    }

    /** The next token; null at the end. */
    Token next() throws IOException {
        Token token = peek();
        peeked = null;
        if (token != null) {
            last = token.place();
        }
        return token;
    }

    private Token read() throws IOException {
        while (!open.isEmpty()) {
            Lexer lexer = open.peek();
            Token token = lexer.next();
            if (closedCharacters + lexer.characters() > LARGEST) {
                throw lexer.place()
                        .failure("the scene is longer than " + LARGEST + " characters with what it includes");
            }
            if (token != null) {
                return token;
            }
            closedCharacters += lexer.characters();
            open.pop().close();
            if (imported.remove(lexer)) {
                return new Token(Token.Kind.FILE_END, "the end of an imported file", lexer.place());
            }
        }
        return null;
    }

    /** The word that must come next, such as a number. */
    Token expect(Token.Kind kind, String what) throws IOException {
        Token token = peek();
        if (token == null || token.kind() != kind) {
            throw last.failure(
                    "expected " + what + ", not " + (token == null ? "the end" : Plain.quoted(token.text())));
        }
        return next();
    }

    /** Numbers that must come next, in brackets or not. */
    double[] numbers(int count, String what) throws IOException {
        Token first = peek();
        boolean isBracketed = first != null && first.kind() == Token.Kind.OPEN;
        if (isBracketed) {
            next();
        }
        double[] values = new double[count];
        for (int i = 0; i < count; i++) {
            values[i] = number(expect(Token.Kind.WORD, what), what);
        }
        if (isBracketed) {
            expect(Token.Kind.CLOSE, "a closing bracket after " + what);
        }
        return values;
    }

    /** The number that a word is. */
    static double number(Token word, String what) {
        double value = Numbers.parse(word.text());
        if (Double.isNaN(value) || Double.isInfinite(value)) {
            throw word.place().failure("expected " + what + ", not " + Plain.quoted(word.text()));
        }
        return value;
    }

    /**
     * Goes on with the tokens of another file.
     *
     * @param name as it stands in the scene
     * @param hasEnd whether its end is a token
     */
    void include(String name, boolean hasEnd) throws IOException {
        Place place = last;
        Path file = file(name, place);
        boolean isOpen = open.stream().anyMatch(l -> l.file().toAbsolutePath().equals(file.toAbsolutePath()));
        if (isOpen || open.size() > DEEPEST) {
            throw place.failure((isOpen ? "files include each other in a circle: " : "files are included too deep: ")
                    + chain(file));
        }
        if (peeked != null) {
            throw place.failure("an include must not stand inside of a list");
        }
        open.push(new Lexer(file, false));
        if (hasEnd) {
            imported.add(open.peek());
        }
    }

    private String chain(Path file) {
        StringBuilder names = new StringBuilder();
        Iterator<Lexer> lexers = open.descendingIterator();
        while (lexers.hasNext()) {
            names.append(lexers.next().file().getFileName()).append(" > ");
        }
        return names.append(file.getFileName()).toString();
    }

    /**
     * A file that the scene names.
     *
     * @throws SceneException if there is none, it is not to be read, or compressed
     */
    Path file(String name, Place place) {
        if (name.toLowerCase(Locale.ROOT).endsWith(".gz")) {
            throw place.failure(
                    Plain.quoted(name) + " is compressed by gzip, which is not read; unpack it with gunzip");
        }
        try {
            return folder.file(name);
        } catch (IOException e) {
            throw place.failure(e.getMessage());
        }
    }

    @Override
    public void close() throws IOException {
        while (!open.isEmpty()) {
            open.pop().close();
        }
    }
}
