package evaluation
{
    /** A part of the evaluation, done in steps so that the player lives on between them. */
    public class Task
    {
        /** What is done, for the progress bar. */
        public var title:String;

        /** How long it takes, roughly, in any unit that all tasks share. */
        public var weight:Number;

        /**
         * For subclasses.
         *
         * @param title what is done
         * @param weight how long it takes
         */
        public function Task(title:String, weight:Number)
        {
            this.title = title;
            this.weight = weight;
        }

        /** Does a step, and returns whether that was the last one. */
        public function work():Boolean
        {
            return true;
        }
    }
}
