package enlightenment.engine;

import enlightenment.plan.RenderPlan;
import enlightenment.scene.RenderSettings;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Objects;
import java.util.Optional;

/**
 * A plan as it is kept with the results of its units: what was decided for which budget, and all that is needed to put the picture
 * together.
 *
 * @param round which render of the picture it is the plan of: 1, or more where those before were not as exact as asked
 * @param depth of the file that the budget's error was for ({@link RenderSettings.Budget#depth}); outlines that were kept do not tell
 * @param outline what is rendered
 */
public record KeptPlan(int round, int depth, RenderOutline outline) {
    private static final int FORMAT = 2;

    public KeptPlan {
        Objects.requireNonNull(outline, "outline");
        if (round < 1) {
            throw new IllegalArgumentException("round " + round);
        }
    }

    /** The plan of a round of a render. */
    public static KeptPlan of(int round, RenderOutline outline) {
        return new KeptPlan(round, outline.settings().budget().depth(), outline);
    }

    /** As bytes: the same for the same plan, on every machine. */
    public byte[] toBytes() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeByte(FORMAT);
            out.writeInt(round);
            out.writeInt(depth);
            OutlineBytes.write(out, outline);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    /** The plan in the bytes of {@link #toBytes}; empty for bytes that this version cannot read. */
    public static Optional<KeptPlan> read(byte[] bytes) {
        try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes))) {
            if (in.readByte() != FORMAT) {
                return Optional.empty();
            }
            int round = in.readInt();
            int depth = in.readInt();
            return Optional.of(new KeptPlan(round, depth, OutlineBytes.readOutline(in, 1)));
        } catch (IOException | IllegalArgumentException | ArithmeticException e) {
            return Optional.empty();
        }
    }

    /** Whether the plan was decided for the budget of these settings, in that round. */
    public boolean isFor(RenderSettings settings, int number) {
        RenderSettings own = outline.settings();
        return round == number
                && own.antialias() == settings.antialias()
                && own.budget().equals(withoutDepth(settings.budget()))
                && (settings.budget().error().isEmpty()
                        || depth == settings.budget().depth());
    }

    private static RenderSettings.Budget withoutDepth(RenderSettings.Budget budget) {
        return new RenderSettings.Budget(budget.samples(), budget.error(), budget.seconds(), 0);
    }

    /** Whether units of the same number give the same results, for renders that differ in their budgets at most. */
    public boolean hasUnitsOf(RenderOutline other) {
        RenderPlan mine = outline.plan();
        RenderPlan its = other.plan();
        return mine.method().word().equals(its.method().word())
                && Double.compare(mine.level(), its.level()) == 0
                && Double.compare(mine.samples(), its.samples()) == 0
                && mine.lightPaths() == its.lightPaths()
                && outline.splatScale().equals(other.splatScale())
                && (mine.level() > 0
                        || outline.settings().antialias() == other.settings().antialias());
    }

    /** Whether the plan has fewer samples per pixel than another, made by the same method or its stand-in. */
    public boolean hasFewerSamplesThan(RenderOutline other) {
        return outline.plan().samples() < other.plan().samples();
    }
}
