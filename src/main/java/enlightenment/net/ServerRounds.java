package enlightenment.net;

import enlightenment.engine.DividedRender;
import enlightenment.engine.Rendered;
import enlightenment.math.InvalidValueException;
import enlightenment.plan.Rounds;
import enlightenment.render.RenderProgress;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** The rounds of a server, each with more samples than the one before, until the picture is as exact as was asked. */
final class ServerRounds {
    private final RoundChain chain;
    private ServedPicture picture;

    /** The audits of the best picture so far. */
    private AuditCount audits = AuditCount.NONE;

    ServerRounds(ServerRound first, ServedPicture picture) {
        chain = new RoundChain(first);
        this.picture = picture;
    }

    /** Renders round after round; returns the last picture that became whole, or what there is of the first. */
    Rendered await(RenderProgress progress, BooleanSupplier cancelled) throws IOException {
        Rendered best = result(chain.latest(), progress, cancelled);
        audits = audits(chain.latest());
        ServerRound next = after(best, cancelled);
        while (next != null) {
            try {
                Rendered result = result(next, progress, cancelled);
                if (result.complete()) {
                    best.image().release();
                    best = result;
                    audits = audits(next);
                    next = after(best, cancelled);
                } else {
                    next.end(false);
                    sayStopped(best);
                    next = null;
                }
            } catch (IOException | UncheckedIOException e) {
                // There is a picture already.
                next.say(e.getMessage());
                next = null;
            }
        }
        return best;
    }

    private static AuditCount audits(ServerRound round) {
        return AuditCount.ofTiles(round.auditsDue(), round.auditsMissing());
    }

    /** The audits of the picture that {@link #await} returned. */
    AuditCount audits() {
        return audits;
    }

    private Rendered result(ServerRound round, RenderProgress progress, BooleanSupplier cancelled) throws IOException {
        round.await(progress, cancelled, () -> {});
        return picture.film().result();
    }

    /** Ends the latest round; returns the one that goes on, or null if there is no more to do. */
    private ServerRound after(Rendered result, BooleanSupplier cancelled) {
        ServerRound round = chain.latest();
        DividedRender more = cancelled.getAsBoolean() || chain.isStopped() ? notBegun(result) : more(result, round);
        if (more == null) {
            round.end(false);
            return null;
        }
        ServedPicture before = picture;
        ServerRound further = null;
        try {
            further = chain.follow(() -> {
                if (picture == before) {
                    // What it takes on the disk is needed.
                    before.film().film().release();
                    picture = before.with(more);
                }
                return picture.job(round.log());
            });
        } catch (InvalidValueException | UncheckedIOException e) {
            // There is a picture already.
            round.say("what is to be rendered again with more samples cannot be: " + e.getMessage());
        }
        before.film().film().release();
        if (further == null && chain.isStopped()) {
            sayStopped(result);
        }
        return further;
    }

    /** Logs that the render was stopped if a further round would follow. Returns null. */
    private DividedRender notBegun(Rendered result) {
        if (picture.render().course().next(result, why -> {}).isPresent()) {
            sayStopped(result);
        }
        return null;
    }

    private void sayStopped(Rendered best) {
        chain.latest().say(Rounds.stopped(best.report()));
    }

    /** The render of the next round; null if none follows, or its planning was cancelled. */
    private DividedRender more(Rendered result, ServerRound round) {
        try {
            return picture.render().next(result, round::say).orElse(null);
        } catch (CancellationException e) {
            sayStopped(result);
            return null;
        }
    }

    /** Ends the latest round, and no other will follow. */
    void stop() {
        chain.stop();
    }
}
