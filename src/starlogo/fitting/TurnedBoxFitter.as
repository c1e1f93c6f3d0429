package starlogo.fitting
{
    /** The base of fitters that turn a box by multiples of an increment, and keep the smallest (thesis §3.4.2). */
    public class TurnedBoxFitter extends Fitter
    {
        private var _degIncrement:Number;

        /**
         * For subclasses only.
         *
         * @param degIncrement the increment in degrees, above 0
         * @throws ArgumentError if it is not a positive, finite number
         */
        public function TurnedBoxFitter(degIncrement:Number)
        {
            this.degIncrement = degIncrement;
        }

        /**
         * The increment in degrees.
         *
         * @throws ArgumentError if it is set to what is not a positive, finite number
         */
        public function get degIncrement():Number
        {
            return _degIncrement;
        }

        public function set degIncrement(value:Number):void
        {
            if (!(value > 0 && value < Infinity))
            {
                throw new ArgumentError("the increment must be a positive number of degrees: " + value);
            }
            _degIncrement = value;
        }
    }
}
