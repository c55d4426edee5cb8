package enlightenment.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * No constant in the code that decides pixels knows a scale: every floating-point literal other than 0, 1/2, 1 and 2 is
 * listed here with the reason why it is none. (Bit-identity under scaling, {@code ImageInvarianceTest}, finds what is not
 * written as a literal.)
 */
class FloatingLiteralsTest {
    private static final List<String> PACKAGES =
            List.of("math", "geometry", "accel", "compiled", "film", "shading", "method", "sampling", "camera");

    /** Literals that say nothing about a scale. */
    private static final Set<Double> FREE = Set.of(0.0, 0.5, 1.0, 2.0);

    /**
     * A literal that is no scale.
     *
     * @param file below src/main/java/enlightenment
     * @param literal as it is written
     * @param why what it stands for
     */
    private record Explained(String file, String literal, String why) {}

    private static final List<Explained> EXPLAINED = List.of(
            new Explained("math/Scale.java", "0x1p-53", "unit roundoff of doubles: the format itself"),
            new Explained("math/Angles.java", "0.198912367379658", "tan(π/16): where a reduction of the angle changes"),
            new Explained("math/Angles.java", "0.41421356237309503", "tan(π/8): what the reduction subtracts"),
            new Explained("math/Angles.java", "0.6681786379192989", "tan(3π/16): where the reduction changes"),
            new Explained("math/Scale.java", "0x1p100", "brings a subnormal number into the normal range, exactly"),
            new Explained(
                    "geometry/SpherePrimitive.java", "0.75", "ratio of two roots that chooses between equal forms"),
            new Explained("geometry/Ray.java", "0x1p240", "where squares could overflow: chooses the rescaling path"),
            new Explained("geometry/Ray.java", "0x1p-240", "where squares could underflow: chooses the rescaling path"),
            new Explained(
                    "geometry/Parallelograms.java",
                    "0x1p-26",
                    "validation limit, relative to the rectangle's own longer edge"),
            new Explained(
                    "compiled/CompiledCamera.java", "-16", "units of the frame, in which every coordinate is below 2"),
            new Explained("sampling/Hash.java", "0x1p-53", "maps 53 random bits to [0, 1)"),
            new Explained("sampling/Sobol.java", "0x1p-32", "maps 32 bits of a sequence to [0, 1)"),
            new Explained("sampling/Warp.java", "6.0", "3!, sine series"),
            new Explained("sampling/Warp.java", "24.0", "4!, cosine series"),
            new Explained("sampling/Warp.java", "120.0", "5!, sine series"),
            new Explained("sampling/Warp.java", "720.0", "6!, cosine series"),
            new Explained("sampling/Warp.java", "5040.0", "7!, sine series"),
            new Explained("sampling/Warp.java", "40320.0", "8!, cosine series"),
            new Explained("sampling/Warp.java", "362880.0", "9!, sine series"),
            new Explained("sampling/Warp.java", "3628800.0", "10!, cosine series"),
            new Explained("sampling/Warp.java", "39916800.0", "11!, sine series"),
            new Explained("sampling/Warp.java", "479001600.0", "12!, cosine series"),
            new Explained("sampling/Warp.java", "6227020800.0", "13!, sine series"),
            new Explained("sampling/Warp.java", "87178291200.0", "14!, cosine series"),
            new Explained("sampling/Warp.java", "1307674368000.0", "15!, sine series"),
            new Explained("sampling/Warp.java", "20922789888000.0", "16!, cosine series"),
            new Explained("sampling/Warp.java", "355687428096000.0", "17!, sine series"),
            new Explained("sampling/Warp.java", "6402373705728000.0", "18!, cosine series"));

    /** Comments, texts and characters: what is not code. Longer forms first. */
    private static final Pattern NOT_CODE = Pattern.compile(
            "//[^\n]*|/\\*.*?\\*/|\"\"\".*?\"\"\"|\"(?:\\\\.|[^\"\\\\\n])*\"|'(?:\\\\.|[^'\\\\\n])+'", Pattern.DOTALL);

    /** Java's floating-point literals: hexadecimal; with a point; with an exponent; with a suffix. */
    private static final Pattern LITERAL = Pattern.compile("(?<![\\w.])(?:"
            + "0[xX][0-9a-fA-F_]*\\.?[0-9a-fA-F_]*[pP][+-]?[0-9_]+[fFdD]?"
            + "|[0-9][0-9_]*\\.[0-9_]*(?:[eE][+-]?[0-9_]+)?[fFdD]?"
            + "|\\.[0-9][0-9_]*(?:[eE][+-]?[0-9_]+)?[fFdD]?"
            + "|[0-9][0-9_]*[eE][+-]?[0-9_]+[fFdD]?"
            + "|[0-9][0-9_]*[fFdD]"
            + ")(?!\\w)");

    /** A whole number that becomes a double because of where it stands. */
    private static final Pattern WHOLE_AS_DOUBLE =
            Pattern.compile("\\b(?:double|float)\\s+\\w+\\s*=\\s*(-?[0-9_]+)\\s*;");

    private static List<String> literals(String source) {
        String code = NOT_CODE.matcher(source).replaceAll(" ");
        List<String> all = new ArrayList<>();
        for (Matcher m = LITERAL.matcher(code); m.find(); ) {
            all.add(m.group());
        }
        for (Matcher m = WHOLE_AS_DOUBLE.matcher(code); m.find(); ) {
            all.add(m.group(1));
        }
        return all;
    }

    private static boolean isFree(String literal) {
        return FREE.contains(Double.parseDouble(literal.replace("_", "")));
    }

    private static Set<String> found() throws IOException {
        Path root = Path.of(System.getProperty("project.directory"), "src", "main", "java", "enlightenment");
        Set<String> found = new TreeSet<>();
        for (String name : PACKAGES) {
            try (Stream<Path> files = Files.walk(root.resolve(name))) {
                for (Path file :
                        files.filter(f -> f.toString().endsWith(".java")).toList()) {
                    String relative = root.relativize(file).toString().replace('\\', '/');
                    for (String literal : literals(Files.readString(file))) {
                        if (!isFree(literal)) {
                            found.add(relative + ": " + literal);
                        }
                    }
                }
            }
        }
        return found;
    }

    @Test
    void everyFloatingLiteralOfTheGeometryIsExplained() throws IOException {
        Set<String> unexplained = found();
        for (Explained e : EXPLAINED) {
            unexplained.remove(e.file + ": " + e.literal);
        }
        assertEquals(Set.of(), unexplained, "say in this test why these know no scale, or remove them");
    }

    @Test
    void everyExplainedLiteralIsStillThere() throws IOException {
        Set<String> listed = new HashSet<>();
        for (Explained e : EXPLAINED) {
            listed.add(e.file + ": " + e.literal);
            assertEquals(false, e.why.isBlank());
        }
        listed.removeAll(found());
        assertEquals(Set.of(), listed);
    }

    @Test
    void theScanSeesEveryFormOfLiteralAndNothingElse() {
        String source =
                """
                /** 1e-6 in a comment */ // 2e-7 in another
                String s = "3e-8 \\" 4e-9"; char c = '5'; int i = 42; long l = 0xFFL; int k = a[1].length;
                double a = 1e-3, b = 1.5, d = .25, e = 6., f = 7d, g = 0x1.8p-4, h = 1_000.5e+2, n = 8f;
                double w = 16;
                double v = -12 ;
                """;
        assertEquals(
                List.of("1e-3", "1.5", ".25", "6.", "7d", "0x1.8p-4", "1_000.5e+2", "8f", "16", "-12"),
                literals(source));
    }
}
