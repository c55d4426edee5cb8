package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/**
 * Measures what textbook forms of intersections get wrong, and what ours do, and prints it: the text of {@code
 * docs/notes/numerics-tables.md}, which names the command.
 */
final class ErrorTables {
    /**
     * A way to place rays.
     *
     * @param name the table's word for it
     * @param size the size of the primitive
     * @param distance where rays start, in sizes
     * @param length the length of directions
     * @param grazing whether rays pass close to the outline
     */
    record Scenario(String name, double size, double distance, double length, boolean grazing) {}

    static final List<Scenario> SCENARIOS = List.of(
            new Scenario("10 sizes away", 1, 10, 1, false),
            new Scenario("close to the outline", 1, 10, 1, true),
            new Scenario("1e3 sizes away", 1, 1e3, 1, false),
            new Scenario("1e6 sizes away", 1, 1e6, 1, false),
            new Scenario("1e9 sizes away", 1, 1e9, 1, false),
            new Scenario("size 1e-9", 1e-9, 10, 1, false),
            new Scenario("size 1e9", 1e9, 10, 1, false),
            new Scenario("size 1e-150", 1e-150, 10, 1, false),
            new Scenario("size 1e150", 1e150, 10, 1, false),
            new Scenario("direction of length 1e-200", 1, 10, 1e-200, false));

    private static final String HEAD = "rays | decided | wrong, textbook | wrong, ours | t off, textbook | t off, ours"
            + " | error of t, textbook | error of t, ours | ulp off, textbook | ulp off, ours |";
    private static final String RULE = "--:|".repeat(10);

    /** The offset of the usual trick against hitting the surface that a ray starts on. */
    private static final double USUAL_OFFSET = 1e-6;

    /** Rays per row of the document. */
    private static final int RAYS = 1000;

    private final PrintStream out;
    private final int rays;

    private ErrorTables(PrintStream out, int rays) {
        this.out = out;
        this.rays = rays;
    }

    /** Writes the document to the file that the only argument names. */
    public static void main(String[] args) throws IOException {
        Files.writeString(Path.of(args[0]), text());
    }

    /** The document. */
    static String text() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        print(new PrintStream(bytes, false, StandardCharsets.UTF_8), RAYS);
        return bytes.toString(StandardCharsets.UTF_8);
    }

    static void print(PrintStream out, int rays) {
        ErrorTables tables = new ErrorTables(out, rays);
        tables.introduction();
        tables.vectors();
        tables.generated();
        tables.leaks();
        tables.faces();
        tables.leaving();
    }

    private void introduction() {
        out.print(
                """
                # Tables of errors

                Written by this command, the same everywhere; do not edit.

                ```
                mvn -q -Perror-tables test-compile exec:exec
                ```

                "Textbook" is the form that books print, in the same double arithmetic: the quadratic formula for
                sphere, cylinder and cone, Ferrari's formula for the torus, slabs with `Math.min` and `Math.max` for the
                box, Möller and Trumbore's triangle (`src/test/java/enlightenment/primitive/NaiveForms.java`). "Ours" is
                what the renderer does. The truth is decimal arithmetic of 60 digits or more on the same doubles.

                - **decided**: rays whose clearance from the border between hit and miss is more than 4uD, u = 2^-53,
                  D = distance plus size. Only these are judged.
                - **wrong**: a miss for a hit, or a hit for a miss.
                - **t off**: the distance is off by more than 64uD/cos(angle of incidence).
                - **error of t**: the largest relative error, however flat the incidence.
                - **ulp off**: the largest distance of the hit point from the surface, in units in the last place of the
                  largest coordinate of point or primitive. Textbooks take the point o + t·d.

                A dash stands where there is nothing to measure, because every hit was missed.

                """);
    }

    private void heading(String title, String text) {
        out.print("## " + title + "\n\n" + text + "\n\n");
    }

    private void vectors() {
        heading(
                "The shipped vectors",
                "`intersection-vectors.jsonl`: hit or miss where the file's margin is 1024 roundings or more, t within the\n"
                        + "file's tolerance.");
        out.print("| primitive | " + HEAD + "\n|---|" + RULE + "\n");
        for (String kind : Subject.KINDS) {
            ErrorTally tally = vectors(kind);
            if (tally.rays > 0) {
                out.print("| " + kind + " | " + tally.cells() + "\n");
            }
        }
        out.print("\n");
    }

    static ErrorTally vectors(String kind) {
        ErrorTally tally = new ErrorTally();
        for (Vectors.Case c : Vectors.of(kind)) {
            Truth.Verdict verdict = new Truth.Verdict(c.margin() >= 1024, c.hit() ? c.decimal("t") : null);
            double tolerance = c.hit() ? c.number("tTol") : 0;
            tally.add(Subject.of(c), c.triple("origin"), c.triple("direction"), verdict, tolerance);
        }
        return tally;
    }

    private void generated() {
        heading("Generated rays", "Random primitives in any position, from outside.");
        out.print("| primitive | placed | " + HEAD + "\n|---|---|" + RULE + "\n");
        for (String kind : Subject.KINDS) {
            for (Scenario scenario : SCENARIOS) {
                ErrorTally tally = generated(kind, scenario, rays);
                out.print("| " + kind + " | " + scenario.name + " | " + tally.cells() + "\n");
            }
        }
        out.print("\n");
    }

    static ErrorTally generated(String kind, Scenario scenario, int rays) {
        RandomRays random = new RandomRays(40);
        ErrorTally tally = new ErrorTally();
        for (int i = 0; i < rays; i++) {
            double size = scenario.size;
            Subject s = Subject.random(kind, random, size, random.inCube().times(size));
            Vec3 o = s.center().plus(random.direction().times(size * scenario.distance));
            Vec3 target = s.center().plus(random.inCube().times(size * 0.4));
            if (scenario.grazing) {
                target = outline(s, random, o);
            }
            Vec3 d = target.minus(o).normalized();
            tally.add(s, o, scenario.length == 1 ? d : d.times(scenario.length));
        }
        return tally;
    }

    /** A point beside which the ray from o just hits or just misses, up to 1e-3 and down to 1e-15 sizes from the outline. */
    private static Vec3 outline(Subject s, RandomRays random, Vec3 o) {
        Vec3 in = s.surfacePoint(random).point();
        Vec3 out = s.center()
                .plus(o.minus(s.center()).cross(random.direction()).normalized().times(2 * s.size()));
        double lo = 0;
        double hi = 1;
        for (int i = 0; i < 50; i++) {
            double middle = (lo + hi) / 2;
            Vec3 d = in.plus(out.minus(in).times(middle)).minus(o);
            if (s.ours().nearest(Ray.of(o, d), Double.MAX_VALUE) < Primitive.MISS) {
                lo = middle;
            } else {
                hi = middle;
            }
        }
        return in.plus(out.minus(in).times(lo + random.decade(-15, -3)));
    }

    private void leaks() {
        heading(
                "Closed surfaces of triangles",
                "Rays from within a closed mesh of 1280 triangles at its edges and vertices: those that meet no triangle. Far from\n"
                        + "the origin the points of an edge are rounded to a coarser grid than the tests round, so few rays pass close\n"
                        + "enough to it.");
        out.print("| mesh at | aimed at | rays | leaks, textbook | leaks, ours |\n|---|---|--:|--:|--:|\n");
        for (double shift : new double[] {0, 1e3, 1e6}) {
            for (String aim : List.of("edges", "vertices")) {
                int[] leaks = leaks(shift, aim, 10 * rays);
                out.print("| " + plain(shift) + " | " + aim + " | " + 10 * rays + " | " + leaks[ErrorTally.NAIVE]
                        + " | " + leaks[ErrorTally.OURS] + " |\n");
            }
        }
        out.print("\n");
    }

    static int[] leaks(double shift, String aim, int rays) {
        RandomRays random = new RandomRays(17);
        Icosphere mesh = new Icosphere(random, 3);
        Vec3 middle = new Vec3(shift, shift, shift);
        Vec3[] vertices = mesh.shiftedVertices(middle);
        int[][] triangles = mesh.triangles();
        Subject[] faces = new Subject[triangles.length];
        for (int i = 0; i < faces.length; i++) {
            int[] f = triangles[i];
            faces[i] = Subject.triangle(vertices[f[0]], vertices[f[1]], vertices[f[2]]);
        }
        int[] leaks = new int[2];
        for (int i = 0; i < rays; i++) {
            int[] f = triangles[random.index(triangles.length)];
            Vec3 a = vertices[f[0]];
            double along = aim.equals("edges") ? random.uniform() : 0;
            Vec3 o = middle.plus(random.inCube().times(0.3));
            Vec3 d = a.plus(vertices[f[1]].minus(a).times(along)).minus(o);
            Ray ray = Ray.of(o, d);
            boolean naive = false;
            boolean ours = false;
            for (Subject face : faces) {
                naive |= face.naive().nearest(o, d, 0) < Primitive.MISS;
                ours |= face.ours().nearest(ray, Double.MAX_VALUE) < Primitive.MISS;
            }
            leaks[ErrorTally.NAIVE] += naive ? 0 : 1;
            leaks[ErrorTally.OURS] += ours ? 0 : 1;
        }
        return leaks;
    }

    private void faces() {
        heading(
                "Rays in the faces of boxes",
                "Rays that lie exactly in a face, or in an edge, and meet the closed box.");
        out.print("| lying in | rays | missed, textbook | missed, ours |\n|---|--:|--:|--:|\n");
        for (int fixed = 1; fixed <= 2; fixed++) {
            int[] missed = faces(fixed, 10 * rays);
            out.print("| " + (fixed == 1 ? "a face" : "an edge") + " | " + 10 * rays + " | " + missed[ErrorTally.NAIVE]
                    + " | " + missed[ErrorTally.OURS] + " |\n");
        }
        out.print("\n");
    }

    /** Rays that stay in a face in this many coordinates. */
    static int[] faces(int fixed, int rays) {
        RandomRays random = new RandomRays(14);
        int[] missed = new int[2];
        for (int i = 0; i < rays; i++) {
            Subject s = Subject.random("box", random, 1, random.inCube());
            Vec3 min = s.ours().bounds().min();
            Vec3 extent = s.ours().bounds().extent();
            double[] target = new double[3];
            double[] d = new double[3];
            int first = random.index(3);
            for (int k = 0; k < 3; k++) {
                boolean stays = (k - first + 3) % 3 < fixed;
                boolean low = random.index(2) == 0;
                double lo = min.component(k);
                double hi = s.ours().bounds().max().component(k);
                target[k] = stays ? (low ? lo : hi) : lo + extent.component(k) * (0.1 + 0.8 * random.uniform());
                d[k] = stays ? (random.index(2) == 0 ? 0.0 : -0.0) : random.signed();
            }
            Vec3 direction = new Vec3(d[0], d[1], d[2]);
            Vec3 o = new Vec3(target[0], target[1], target[2]).minus(direction.times(3));
            missed[ErrorTally.NAIVE] += s.naive().nearest(o, direction, 0) < Primitive.MISS ? 0 : 1;
            missed[ErrorTally.OURS] +=
                    s.ours().nearest(Ray.of(o, direction), Double.MAX_VALUE) < Primitive.MISS ? 0 : 1;
        }
        return missed;
    }

    private void leaving() {
        heading(
                "Leaving a surface",
                "Rays of unit length from points on the surface, half of them within 1e-6..1e-1 of the tangent plane. Textbook:\n"
                        + "crossings with t > 1e-6. Ours: the primitive and the side that the ray starts on. **lost**: a ray\n"
                        + "that travels inside finds no exit. **self-hits**: a ray that travels outside finds its own surface\n"
                        + "although it cannot meet it again. For the torus, which a ray may well meet again, the truth is the\n"
                        + "quartic without the root that the start is.");
        out.print("| primitive | size | offset in sizes | rays | lost, textbook | lost, ours | self-hits, textbook"
                + " | self-hits, ours |\n|---|--:|--:|--:|--:|--:|--:|--:|\n");
        for (String kind : List.of("sphere", "cylinder", "cone", "torus", "box")) {
            for (double size : new double[] {1e-3, 1, 1e3, 1e6}) {
                leavingRow(kind, size, 0);
            }
            leavingRow(kind, 1, 1e6);
        }
    }

    private void leavingRow(String kind, double size, double shift) {
        int[][] counts = leaving(kind, size, shift, rays);
        out.print("| " + kind + " | " + plain(size) + " | " + plain(shift) + " | " + 2 * rays);
        for (int[] what : counts) {
            out.print(" | " + what[ErrorTally.NAIVE] + " | " + what[ErrorTally.OURS]);
        }
        out.print(" |\n");
    }

    /** How many exits are lost [0] and how many surfaces are hit where they cannot be [1]. */
    static int[][] leaving(String kind, double size, double shift, int rays) {
        RandomRays random = new RandomRays(18);
        int[][] counts = new int[2][2];
        for (int i = 0; i < rays; i++) {
            Vec3 at = random.direction().times(shift * size);
            Subject s = Subject.random(kind, random, size, at);
            Hit start = s.surfacePoint(random);
            Vec3 p = start.point();
            double cosine = i % 2 == 0 ? random.uniform() : Math.abs(random.decade(-6, -1));
            for (int side : new int[] {Ray.INSIDE, Ray.OUTSIDE}) {
                Vec3 d = random.leaving(start.normal(), side * cosine).normalized();
                boolean meets = side == Ray.INSIDE || s.kind().equals("torus") && meetsAgain(s, p, d);
                boolean naive = s.naive().nearest(p, d, USUAL_OFFSET) < Primitive.MISS;
                double t = s.ours().nearest(Ray.leaving(p, d, s.ours(), side), Double.MAX_VALUE);
                count(counts, ErrorTally.NAIVE, meets, naive);
                count(counts, ErrorTally.OURS, meets, t < Primitive.MISS);
            }
        }
        return counts;
    }

    private static boolean meetsAgain(Subject s, Vec3 p, Vec3 d) {
        TorusPrimitive t = (TorusPrimitive) s.ours();
        List<BigDecimal> again =
                new TorusTruth(t.center(), t.axis(), t.majorRadius(), t.minorRadius(), p, d).crossingsAfterStart();
        return !again.isEmpty();
    }

    private static void count(int[][] counts, int which, boolean meets, boolean met) {
        counts[0][which] += meets && !met ? 1 : 0;
        counts[1][which] += met && !meets ? 1 : 0;
    }

    private static String plain(double v) {
        return v == 0 || v == 1 ? Integer.toString((int) v) : String.format(Locale.ROOT, "%.0e", v);
    }
}
