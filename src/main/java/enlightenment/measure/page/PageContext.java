package enlightenment.measure.page;

import enlightenment.measure.analysis.CostEstimate;
import enlightenment.measure.analysis.Verdict;
import enlightenment.measure.trade.TradeSettings;

/**
 * Texts of the page that are not in the measurement.
 *
 * @param title the scene's name
 * @param renderCommand the command line of a render without the advised options: program, scene, output, options that were given
 * @param compareCommand the command line that compares the picture with the reference
 * @param tradeCommand the command line that made the page
 */
public record PageContext(String title, String renderCommand, String compareCommand, String tradeCommand) {
    private static final String SHADOW_SAMPLES = " --shadow-samples ";

    /** The command line of an advice; its number of light samples replaces one that was given. */
    public String render(CostEstimate advice, TradeSettings settings) {
        String options = " " + Verdict.arguments(advice, settings);
        String command = options.contains(SHADOW_SAMPLES)
                ? renderCommand.replaceFirst(SHADOW_SAMPLES + "\\S+", "")
                : renderCommand;
        return command + options;
    }
}
