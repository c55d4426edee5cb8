package enlightenment.cli.store;

import enlightenment.cli.terminal.CliException;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.store.StoredSamples;
import java.util.stream.Collectors;
import picocli.CommandLine.Option;

/** The options that say whether camera samples are kept one by one. */
public final class SampleOptions {
    @Option(
            names = "--store-samples",
            description = "keep every camera sample in the store, too: place, colour and weight, 28 bytes each")
    private boolean samples;

    @Option(
            names = "--store-rays",
            description = "the same with its ray: window, surface and light point, what became of it, 102 bytes each")
    private boolean rays;

    public SampleOptions() {}

    /** Fails if the method cannot tell of its samples. */
    public void check(RenderSettings settings) {
        if ((samples || rays) && !Renderer.recordsSamples(settings.method())) {
            String can = Method.all().stream()
                    .filter(Renderer::recordsSamples)
                    .map(Method::word)
                    .collect(Collectors.joining(", "));
            throw CliException.wrongUsage((rays ? "--store-rays" : "--store-samples") + ": method "
                    + settings.method().word() + " does not tell of its samples one by one; " + can + " does");
        }
    }

    /** The data of camera samples to keep. */
    public StoredSamples wanted() {
        return rays ? StoredSamples.RAYS : samples ? StoredSamples.PIXELS : StoredSamples.NONE;
    }
}
