package starlogo.search
{
    import starlogo.engine;

    use namespace engine;

    /**
     * The pairs of breeds that are of interest, with a number for each breed, so that a frame compares no names. The order within a pair does not
     * matter.
     *
     * @private
     */
    public final class BreedPairs
    {
        /** In place of a breed's name: any breed. An agent whose own breed has this name is of a breed like any other. */
        public static const ANY_BREED:String = "*";

        /** Whether a pair of breeds is of interest, at the number of one breed times breedCount plus that of the other. */
        public var areOfInterest:Vector.<Boolean> = new Vector.<Boolean>();

        /** Whether every pair of the breeds that have numbers is of interest. */
        public var areAll:Boolean = true;

        /** Counts the changes: numbers of breeds are those of one revision. */
        public var revision:int = 0;

        private var _breeds:Vector.<String> = new Vector.<String>();
        private var _hasAny:Boolean = false;

        // breed, otherBreed, breed, otherBreed, ...
        private var _added:Vector.<String> = new Vector.<String>();

        /** No pairs yet. */
        public function BreedPairs()
        {
        }

        /** How many breeds are told apart: those that were named, and all others as one if ANY_BREED was added. */
        public function get breedCount():int
        {
            return _hasAny ? _breeds.length + 1 : _breeds.length;
        }

        /** Adds a pair of breeds, of which each may be ANY_BREED; a pair that is already there stays. */
        public function add(breed:String, otherBreed:String):void
        {
            _added.push(breed, otherBreed);
            enter(breed);
            enter(otherBreed);
            revision++;
            areOfInterest = new Vector.<Boolean>(breedCount * breedCount);
            for (var i:int = 0; i < _added.length; i += 2)
            {
                markPairs(numbersOf(_added[i]), numbersOf(_added[i + 1]));
            }
            // not by indexOf(false), which finds none in Ruffle: an element that was not set becomes false only when it is read
            areAll = true;
            for each (var isOfInterest:Boolean in areOfInterest)
            {
                areAll = areAll && isOfInterest;
            }
        }

        /** A breed's number, from 0 on; -1 for a breed that is in no pair. */
        public function numberOf(breed:String):int
        {
            var number:int = _breeds.indexOf(breed);
            return number < 0 && _hasAny ? _breeds.length : number;
        }

        /** The numbers of the breeds that a name matches: all of them for ANY_BREED. */
        public function numbersOf(breed:String):Vector.<int>
        {
            if (breed != ANY_BREED)
            {
                return new <int>[_breeds.indexOf(breed)];
            }
            var numbers:Vector.<int> = new Vector.<int>();
            for (var i:int = 0; i < breedCount; i++)
            {
                numbers.push(i);
            }
            return numbers;
        }

        private function enter(breed:String):void
        {
            if (breed == ANY_BREED)
            {
                _hasAny = true;
            }
            else if (_breeds.indexOf(breed) < 0)
            {
                _breeds.push(breed);
            }
        }

        private function markPairs(numbers:Vector.<int>, otherNumbers:Vector.<int>):void
        {
            for each (var number:int in numbers)
            {
                for each (var other:int in otherNumbers)
                {
                    areOfInterest[number * breedCount + other] = true;
                    areOfInterest[other * breedCount + number] = true;
                }
            }
        }
    }
}
