package enlightenment.importer.pbrt;

import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ImportNotes;
import enlightenment.math.Vec3;
import enlightenment.text.Plain;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;

/** The directives that change the current transformation matrix. */
final class Transformations {
    private static final Set<String> DIRECTIVES = Set.of(
            "Identity",
            "Translate",
            "Scale",
            "Rotate",
            "LookAt",
            "Transform",
            "ConcatTransform",
            "CoordinateSystem",
            "CoordSysTransform",
            "TransformTimes",
            "ActiveTransform");

    private final TokenSource in;
    private final ImportNotes notes;
    private final Map<String, Affine> named = new HashMap<>();

    Transformations(TokenSource in, ImportNotes notes) {
        this.in = in;
        this.notes = notes;
    }

    /** Names the current transformation. */
    void name(String name, Affine ctm) {
        named.put(name, ctm);
    }

    static boolean has(String directive) {
        return DIRECTIVES.contains(directive);
    }

    /** Reads the rest of a directive and does what it says. */
    void apply(String directive, GraphicsState state) throws IOException {
        Place place = in.place();
        try {
            Affine next = next(directive, state, place);
            if (state.isFirstKeyActive || directive.equals("ActiveTransform")) {
                state.ctm = next;
            } else {
                notes.add(place.shown(), "what moves stands still where it is at first");
            }
        } catch (IllegalArgumentException e) {
            throw place.failure(directive + ": " + e.getMessage());
        }
    }

    private Affine next(String directive, GraphicsState state, Place place) throws IOException {
        Affine ctm = state.ctm;
        switch (directive) {
            case "Identity":
                return Affine.IDENTITY;
            case "Translate": {
                double[] v = in.numbers(3, "three numbers");
                return ctm.after(Affine.translate(v[0], v[1], v[2]));
            }
            case "Scale": {
                double[] v = in.numbers(3, "three numbers");
                return ctm.after(Affine.scale(v[0], v[1], v[2]));
            }
            case "Rotate": {
                double[] v = in.numbers(4, "an angle and an axis");
                return ctm.after(Affine.rotate(new Vec3(v[1], v[2], v[3]), v[0]));
            }
            case "LookAt": {
                double[] v = in.numbers(9, "nine numbers: eye, target and up");
                Vec3 eye = new Vec3(v[0], v[1], v[2]);
                return ctm.after(Affine.lookAt(eye, new Vec3(v[3], v[4], v[5]), new Vec3(v[6], v[7], v[8]))
                        .inverse());
            }
            case "Transform":
                return matrix();
            case "ConcatTransform":
                return ctm.after(matrix());
            case "CoordinateSystem":
                named.put(in.expect(Token.Kind.STRING, "a name").text(), ctm);
                return ctm;
            case "CoordSysTransform":
                return known(in.expect(Token.Kind.STRING, "a name").text(), place);
            case "TransformTimes":
                in.numbers(2, "two numbers");
                return ctm;
            default:
                return active(state, ctm);
        }
    }

    private Affine active(GraphicsState state, Affine ctm) throws IOException {
        Token which = in.expect(Token.Kind.WORD, "StartTime, EndTime or All");
        if (!Set.of("StartTime", "EndTime", "All").contains(which.text())) {
            throw which.place().failure("expected StartTime, EndTime or All, not " + Plain.quoted(which.text()));
        }
        state.isFirstKeyActive = !which.text().equals("EndTime");
        return ctm;
    }

    /** Files list matrices column by column. */
    private Affine matrix() throws IOException {
        double[] v = in.numbers(16, "the sixteen numbers of a matrix");
        double[] rows = new double[v.length];
        for (int i = 0; i < v.length; i++) {
            rows[4 * (i % 4) + i / 4] = v[i];
        }
        return Affine.ofRows(rows);
    }

    private Affine known(String name, Place place) {
        Affine ctm = named.get(name);
        if (ctm == null) {
            throw place.failure("there is no coordinate system named " + Plain.quoted(name));
        }
        return ctm;
    }
}
