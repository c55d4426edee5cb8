package enlightenment.image.flip;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** ꟻLIP against its authors' implementation; src/test/scripts/flip-reference.py made the values. */
class FlipReferenceTest {
    /**
     * The reference computes in floats. A feature is a difference of sums of weights times luminance, so it is off by about
     * d = 2^-24, and its square root turns a feature that should be 0 into f = √(d/√2) = 2.1e-4. The error c^(1-f) is then
     * off by c·|ln c|·f, at most f/e = 7.6e-5; 4.6e-5 was seen, in evenly coloured pictures. (Pixels whose colours differ by
     * rounding only are worse off, as the power 0.7 blows them up: 2.7e-4 was seen where the error is below 0.001. None of
     * the stored pixels is such a one.)
     */
    private static final double TOLERANCE = 7.6e-5;

    static List<String> lines() throws IOException {
        try (var in = FlipReferenceTest.class.getResourceAsStream("flip/reference.txt")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .filter(line -> !line.startsWith("#"))
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("lines")
    void errorsAreThoseOfTheReferenceImplementation(String line) throws Exception {
        String[] parts = line.split(" ");
        double pixelsPerDegree = Double.parseDouble(parts[1]);
        Flip flip = Flip.between(image(parts[0] + "-a.png"), image(parts[0] + "-b.png"), pixelsPerDegree);
        assertEquals(Double.parseDouble(parts[2]), flip.mean(), TOLERANCE);
        for (int i = 3; i < parts.length; i++) {
            String[] pixel = parts[i].split("[,=]");
            int x = Integer.parseInt(pixel[0]);
            int y = Integer.parseInt(pixel[1]);
            assertEquals(Double.parseDouble(pixel[2]), flip.error(x, y), TOLERANCE, parts[i]);
        }
    }

    private static Image image(String name) throws Exception {
        return ImageFiles.read(
                Path.of(FlipReferenceTest.class.getResource("flip/" + name).toURI()));
    }
}
