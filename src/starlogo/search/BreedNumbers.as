package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Bins;
    import starlogo.engine;

    use namespace engine;

    /** Keeps the numbers of breeds in a table up to date: those of the pairs of breeds that are searched for. */
    internal final class BreedNumbers
    {
        /** How many agents listed have a breed that is in no pair. */
        public var outsiders:int = 0;

        private var _breeds:BreedPairs = null;
        private var _revision:int;
        private var _changes:int;
        private var _list:int;

        /** No breeds yet. */
        public function BreedNumbers()
        {
        }

        /** Brings the numbers of a table up to date. */
        public function update(table:AgentTable, breeds:BreedPairs):void
        {
            var areVoid:Boolean = breeds !== _breeds || breeds.revision != _revision;
            if (!areVoid && Agent.breedChanges == _changes && table.listNumber == _list)
            {
                return;
            }
            _breeds = breeds;
            _revision = breeds.revision;
            var changes:int = _changes;
            _changes = Agent.breedChanges;
            _list = table.listNumber;
            outsiders = 0;
            var numbers:Vector.<int> = table.breeds;
            for (var i:int = 0; i < table.count; i++)
            {
                var row:int = table.rows[i];
                var agent:Agent = table.agents[row];
                if (areVoid || numbers[row] == AgentTable.UNKNOWN_BREED || agent.breedChange > changes)
                {
                    numbers[row] = breeds.numberOf(agent.breed);
                }
                if (numbers[row] < 0)
                {
                    outsiders++;
                }
            }
        }

        /**
         * Moves those candidates of a member to the beginning whose breeds are of interest together with its own.
         *
         * @param others the slots of the candidates
         * @param count how many they are
         * @return how many these are
         */
        public function keepOfInterest(table:AgentTable, bins:Bins, slot:int, others:Vector.<int>, count:int):int
        {
            var numbers:Vector.<int> = table.breeds;
            var rowAt:Vector.<int> = bins.rowAt;
            var areOfInterest:Vector.<Boolean> = _breeds.areOfInterest;
            var first:int = numbers[rowAt[slot]] * _breeds.breedCount;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                if (areOfInterest[first + numbers[rowAt[other]]])
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }
    }
}
