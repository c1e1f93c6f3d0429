package evaluation
{
    /** A part of the evaluation. It is done in steps, so that the player can draw between them. */
    public class Task
    {
        /** The task's name in the progress bar. */
        public var title:String;

        /** How long the task takes, roughly. All tasks share one unit. */
        public var weight:Number;

        /**
         * For subclasses.
         *
         * @param title the task's name
         * @param weight how long it takes
         */
        public function Task(title:String, weight:Number)
        {
            this.title = title;
            this.weight = weight;
        }

        /** Does a step. Returns whether it was the last one. */
        public function work():Boolean
        {
            return true;
        }
    }
}
