package enlightenment.cli.option;

import static enlightenment.cli.option.OptionRule.excludes;
import static enlightenment.cli.option.OptionRule.needs;

import java.util.ArrayList;
import java.util.List;

/**
 * The rules by which options of a command exclude or need others. The first rule that is broken is reported, before any file is read;
 * docs/guide/cli.md lists them all. What depends on an option's value stands with that option.
 */
public final class OptionRules {
    private static final String NO_PICTURE = "with --part there is no picture yet: --depth (but for --error), --format,"
            + " --exposure, --report, --stats, --aov, --denoised, --preview, --serve, --window, --dump-clusters and --dump-chains must not be given";

    private static final OptionRule STORE_LOGIN = needs(
            List.of("--store-user", "--store-password-file"),
            "--store",
            "--store-user and --store-password-file need --store");

    /** The options of {@code ServingOptions}. */
    private static final List<String> SERVING = List.of(
            "--host",
            "--port",
            "--min-workers",
            "--wait",
            "--shares",
            "--token-file",
            "--tls",
            "--tls-cert",
            "--tls-key",
            "--status-port",
            "--local-threads",
            "--audit",
            "--audit-required");

    private static final List<OptionRule> SECRETS = List.of(
            excludes(
                    List.of("--tls"),
                    List.of("--tls-cert", "--tls-key"),
                    "--tls must not be given together with --tls-cert and --tls-key"),
            needs(List.of("--tls-cert"), "--tls-key", "--tls-cert and --tls-key go together"),
            needs(List.of("--tls-key"), "--tls-cert", "--tls-cert and --tls-key go together"));

    public static final List<OptionRule> RENDER = List.of(
            excludes(
                    List.of("--checkpoint", "--store"),
                    List.of("--part"),
                    "%s must not be given with --part: take more parts, of which each is short"),
            // The depth is that of the picture that is to meet an error.
            excludes(List.of("--depth"), List.of("--part"), NO_PICTURE).unless("--error"),
            excludes(
                    List.of(
                            "--format",
                            "--exposure",
                            "--report",
                            "--stats",
                            "--aov",
                            "--denoised",
                            "--preview",
                            "--serve",
                            "--window",
                            "--dump-clusters",
                            "--dump-chains"),
                    List.of("--part"),
                    NO_PICTURE),
            excludes(
                    List.of("--time"),
                    List.of("--part"),
                    "--time must not be given with --part, whose parts would differ: give --samples"),
            needs(
                    List.of("--resume"),
                    "--checkpoint",
                    "--resume needs --checkpoint FILE, from which the render is to go on"),
            STORE_LOGIN,
            needs(List.of("--store-rays", "--store-samples"), "--store", "%s needs --store"),
            excludes(
                    List.of("--checkpoint", "--store"),
                    List.of("--dump-clusters", "--dump-chains"),
                    "%s must not be given with --dump-clusters and --dump-chains: what is kept does not tell of them"));

    public static final List<OptionRule> ANIMATE = and(
            SECRETS,
            needs(SERVING, "--server", "%s is for --server, which is not given"),
            excludes(
                    List.of("--time"),
                    List.of("--server"),
                    "--time must not be given with --server, where no frame has a time of its own:"
                            + " give --samples or --error"),
            excludes(
                    List.of("--aov"),
                    List.of("--server"),
                    "--aov must not be given with --server: workers send colours only"),
            needs(List.of("--ffmpeg"), "--video", "--ffmpeg is for --video, which is not given"));

    public static final List<OptionRule> SERVER = and(
            SECRETS,
            STORE_LOGIN,
            needs(List.of("--pardon"), "--checkpoint", "--pardon needs --checkpoint, which remembers who was expelled"),
            excludes(
                    List.of("--checkpoint", "--store"),
                    List.of("--time"),
                    "%s must not be given with --time, which is planned anew each time: give --samples"));

    public static final List<OptionRule> WORKER =
            List.of(excludes(List.of("--pin"), List.of("--tls-ca"), "--pin and --tls-ca must not be given together"));

    public static final List<OptionRule> COMPARE = List.of(needs(
            List.of("--exposure", "--tone"), "--linear", "--exposure and --tone must only be given with --linear"));

    public static final List<OptionRule> TRADE = List.of(excludes(
            List.of("--evaluate"), List.of("--resume"), "--evaluate measures nothing: it does not go with --resume"));

    private OptionRules() {}

    private static List<OptionRule> and(List<OptionRule> first, OptionRule... more) {
        List<OptionRule> all = new ArrayList<>(first);
        all.addAll(List.of(more));
        return List.copyOf(all);
    }
}
