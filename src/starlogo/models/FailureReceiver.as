package starlogo.models
{
    /**
     * A ModelReceiver that wants to know why a load failed. It is no part of ModelReceiver, which games implement.
     *
     * @private
     */
    public interface FailureReceiver
    {
        /** Called when a load fails, before <code>expectNoMore()</code>. */
        function loadFailed(name:String, problem:Error):void;
    }
}
