package starlogo.diagnostics
{
    import flash.utils.getTimer;
    import starlogo.agents.Agent;
    import starlogo.collision.BaseCollider;
    import starlogo.collision.Collider;
    import starlogo.collision.CollisionStatistics;
    import starlogo.collision.CollisionSystem;
    import starlogo.data.IntPairMap;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.search.BreedInterests;
    import starlogo.search.FoundPairs;
    import starlogo.search.PairReader;
    import starlogo.search.SearchInput;

    use namespace engine;

    /**
     * Records a game's collisions and frame times over its whole run, with any collision system (thesis §7.8, §6.1, §6.2.5). Put it around
     * the collision system that does the work. It finds the same collisions, so the game does not change:
     *
     * <listing version="3.0">
     * var recorder:CollisionRecorder = new CollisionRecorder(new TightestFitCollider(greatLand));
     * var collision:Collision = new Collision(recorder);
     * // at the end of the game
     * trace(recorder.timesToText());
     * trace(recorder.toText());
     * </listing>
     *
     * <p>A frame is a frame of a Collision, or a call of findCollisions or findCollisionsAmong. Pairs of breeds without handlers are counted only in
     * findCollisions. The cost is proportional to the number of collisions: some ten-thousandths of a millisecond for each.</p>
     */
    public final class CollisionRecorder extends BaseCollider
    {
        private var _system:BaseCollider;
        private var _frames:int = 0;
        private var _all:Tally = new Tally();

        // A tally for each pair of breeds, and its index by their numbers, the lesser first.
        private var _pairs:Vector.<Tally> = new Vector.<Tally>();
        private var _indices:IntPairMap = new IntPairMap();

        // The tallies of pairs that collide in the present frame.
        private var _found:Vector.<Tally> = new Vector.<Tally>();

        private var _findTimes:FrameTimes = new FrameTimes();
        private var _frameTimes:FrameTimes = new FrameTimes();

        /**
         * Creates a recorder without frames.
         *
         * @param collisionSystem finds the collisions
         * @throws ArgumentError if it is null
         */
        public function CollisionRecorder(collisionSystem:CollisionSystem)
        {
            super(collisionSystem);
            requireGiven("collisionSystem", collisionSystem);
            _system = BaseCollider.wrap(collisionSystem);
        }

        /** @private */
        override engine function get samePairsCollider():Collider
        {
            return _system.samePairsCollider;
        }

        /** The number of recorded frames. */
        public function get frames():int
        {
            return _frames;
        }

        /** The number of collisions in all recorded frames. */
        public function get collisions():Number
        {
            return _all.collisions;
        }

        /** The times to find the collisions, of the last 10,000 frames. */
        public function get findTimes():FrameTimes
        {
            return _findTimes;
        }

        /** The times of the whole frames of a Collision, with its handlers. Without a Collision there are no such times. */
        public function get frameTimes():FrameTimes
        {
            return _frameTimes;
        }

        /** @inheritDoc */
        override public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return findCollisionsAmong(agents, null, out);
        }

        /** @inheritDoc */
        override public function findCollisionsAmong(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<Agent> = null):Vector.<Agent>
        {
            var start:Number = getTimer();
            out = _system.findCollisionsAmong(agents, interests, out);
            _findTimes.add(getTimer() - start);
            for (var i:int = 0; i < out.length; i += 2)
            {
                countPair(out[i], out[i + 1]);
            }
            endFrame(out.length >> 1);
            return out;
        }

        /** @private */
        override engine function findPairs(input:SearchInput, reader:PairReader, counts:CollisionStatistics):FoundPairs
        {
            var pairs:FoundPairs = _system.findPairs(input, reader, counts);
            _findTimes.add(counts.findMs);
            for (var i:int = 0; i < pairs.count; i++)
            {
                countPair(pairs.firstOf(i), pairs.secondOf(i));
            }
            endFrame(pairs.count);
            return pairs;
        }

        /** @private */
        override engine function onFrame(statistics:CollisionStatistics):void
        {
            _frameTimes.add(statistics.frameMs);
            super.onFrame(statistics);
        }

        /** Removes all recorded frames. */
        public function clear():void
        {
            _frames = 0;
            _all = new Tally();
            _pairs.length = 0;
            _indices.clear();
            _findTimes.clear();
            _frameTimes.clear();
        }

        /**
         * The record as an object for JSON: <code>frames</code>, <code>collisions</code>, <code>mean</code>, <code>most</code>, <code>histogram</code>
         * and <code>breeds</code>.
         *
         * <p>A histogram is a list of <code>{collisions, frames}</code>: the number of frames with that number of collisions. Above 16,
         * numbers are grouped in classes whose widths double. The least number of a class stands for the class. <code>breeds</code> is a
         * list of <code>{breeds, collisions, mean, most, histogram}</code>. The mean is over all frames.</p>
         */
        public function toObject():Object
        {
            var breeds:Array = [];
            for each (var pair:Tally in _pairs)
            {
                breeds.push(pair.addTo({breeds: pair.breeds}, _frames));
            }
            breeds.sortOn("collisions", Array.NUMERIC | Array.DESCENDING);
            var all:Object = _all.addTo({frames: _frames}, _frames);
            all.breeds = breeds;
            return all;
        }

        /** The times in three lines: the counts, finding the collisions, and the whole frames. */
        public function timesToText():String
        {
            return _frames + " frames, " + (_all.collisions / Math.max(1, _frames)).toFixed(1) + " collisions a frame\nfind: " + _findTimes + "\nframe: "
                + _frameTimes;
        }

        /** The record as JSON text. */
        public function toText():String
        {
            return JSON.stringify(toObject(), null, 2);
        }

        private function countPair(a:Agent, b:Agent):void
        {
            var lesser:int = Math.min(a.breedNumber, b.breedNumber);
            var greater:int = Math.max(a.breedNumber, b.breedNumber);
            var index:int = _indices.find(lesser, greater);
            if (index < 0)
            {
                index = _pairs.push(new Tally([a.breed, b.breed])) - 1;
                _indices.set (lesser, greater, index);
            }
            if (_pairs[index].inFrame++ == 0)
            {
                _found.push(_pairs[index]);
            }
        }

        private function endFrame(collisions:int):void
        {
            _frames++;
            _all.inFrame = collisions;
            _all.endFrame();
            for each (var pair:Tally in _found)
            {
                pair.endFrame();
            }
            _found.length = 0;
        }
    }
}

/** Counts the collisions of two breeds, or of all breeds. */
final class Tally
{
    private static const EXACT:int = 16;

    /** The names of two breeds; null for all. */
    public var breeds:Array;

    /** The collisions in the present frame. */
    public var inFrame:int = 0;

    /** The collisions in all earlier frames. */
    public var collisions:Number = 0;

    private var _most:int = 0;

    // The number of frames for each class of numbers of collisions: see leastOf().
    private var _histogram:Vector.<int> = new Vector.<int>();

    /** Creates a tally without collisions. */
    public function Tally(breeds:Array = null)
    {
        this.breeds = breeds;
    }

    /** Ends the present frame. */
    public function endFrame():void
    {
        if (inFrame == 0)
        {
            return;
        }
        var index:int = Math.min(inFrame, EXACT);
        while (leastOf(index + 1) <= inFrame)
        {
            index++;
        }
        while (_histogram.length <= index)
        {
            _histogram.push(0);
        }
        _histogram[index]++;
        _most = Math.max(_most, inFrame);
        collisions += inFrame;
        inFrame = 0;
    }

    /** Adds its numbers to an object for JSON, and returns that. @param frames the number of all frames */
    public function addTo(record:Object, frames:int):Object
    {
        record.collisions = collisions;
        record.mean = frames == 0 ? 0 : collisions / frames;
        record.most = _most;
        record.histogram = [];
        var without:int = frames;
        for (var i:int = 1; i < _histogram.length; i++)
        {
            if (_histogram[i] > 0)
            {
                record.histogram.push({collisions: leastOf(i), frames: _histogram[i]});
                without -= _histogram[i];
            }
        }
        if (without > 0)
        {
            record.histogram.unshift({collisions: 0, frames: without});
        }
        return record;
    }

    // The least number of a class. Up to 16 each number is a class. Then the widths of the classes double: 17 to 33, 34 to 67, and so on.
    private static function leastOf(index:int):int
    {
        return index <= EXACT ? index : ((EXACT + 1) << (index - EXACT)) >> 1;
    }
}
