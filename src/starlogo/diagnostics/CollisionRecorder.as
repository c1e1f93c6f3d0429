package starlogo.diagnostics
{
    import starlogo.agents.Agent;
    import starlogo.collision.BreedInterests;
    import starlogo.collision.CollisionStatistics;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.Contact;
    import starlogo.collision.ContactSystem;
    import starlogo.engine;

    use namespace engine;

    /**
     * Counts a game's collisions over its whole run, so that the average case of real games can be known (thesis §7.8).
     * It is put around the collision system that does the work, and finds what that one finds:
     *
     * <listing version="3.0">
     * var recorder:CollisionRecorder = new CollisionRecorder(new TightestFitCollider(greatLand));
     * var collision:Collision = new Collision(recorder);
     * // at the end of the game
     * trace(recorder.toText());
     * </listing>
     *
     * <p>A frame is a call of findCollisions or findCollisionsAmong. Pairs of breeds without handlers count only in the former. The cost is
     * in proportion to the collisions: some ten-thousandths of a millisecond for each.</p>
     */
    public final class CollisionRecorder implements ContactSystem
    {
        private var _collisionSystem:CollisionSystem;
        private var _frames:int = 0;
        private var _collisions:Number = 0;
        private var _total:Histogram = new Histogram();
        private var _pairs:Vector.<BreedPair> = new Vector.<BreedPair>();
        private var _lastPair:BreedPair;

        /**
         * A recorder that has seen no frame yet.
         *
         * @param collisionSystem finds the collisions
         * @throws ArgumentError if it is null
         */
        public function CollisionRecorder(collisionSystem:CollisionSystem)
        {
            if (collisionSystem == null)
            {
                throw new ArgumentError("collisionSystem must not be null");
            }
            _collisionSystem = collisionSystem;
        }

        /** Finds the collisions. */
        public function get collisionSystem():CollisionSystem
        {
            return _collisionSystem;
        }

        /** How many frames were recorded. */
        public function get frames():int
        {
            return _frames;
        }

        /** The collisions of all recorded frames. */
        public function get collisions():Number
        {
            return _collisions;
        }

        /** @inheritDoc */
        public function get statistics():CollisionStatistics
        {
            return _collisionSystem.statistics;
        }

        /** @inheritDoc */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            return _collisionSystem.areColliding(a, b);
        }

        /** @inheritDoc */
        public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
        {
            out = _collisionSystem.findCollisions(agents, out);
            record(out);
            return out;
        }

        /**
         * @inheritDoc
         *
         * <p>With a system that is not selective, all pairs are found.</p>
         */
        public function findCollisionsAmong(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<Agent>):Vector.<Agent>
        {
            out = BreedInterests.findIn(_collisionSystem, agents, interests, out);
            record(out);
            return out;
        }

        /** @inheritDoc */
        public function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact
        {
            var contact:Contact = out || new Contact();
            contact.readFrom(_collisionSystem, collider, collidee);
            return contact;
        }

        /** Forgets all frames. */
        public function clear():void
        {
            _frames = 0;
            _collisions = 0;
            _total = new Histogram();
            _pairs.length = 0;
            _lastPair = null;
        }

        /**
         * The record as an object for JSON: <code>frames</code>, <code>collisions</code>, <code>histogram</code> and
         * <code>breeds</code>.
         *
         * <p>A histogram is a list of <code>{collisions, frames}</code>: in how many frames there were so many. Numbers
         * above 16 are in classes whose widths double, named by their least. <code>breeds</code> is a list of <code>{breeds,
         * collisions, mean, most, histogram}</code>, the mean being that of all frames.</p>
         */
        public function toObject():Object
        {
            var breeds:Array = [];
            for each (var pair:BreedPair in _pairs)
            {
                breeds.push({breeds: [pair.breed, pair.otherBreed], collisions: pair.collisions,
                            mean: _frames == 0 ? 0 : pair.collisions / _frames, most: pair.histogram.most,
                            histogram: pair.histogram.toArray(_frames)});
            }
            breeds.sortOn("collisions", Array.NUMERIC | Array.DESCENDING);
            return {frames: _frames, collisions: _collisions, mean: _frames == 0 ? 0 : _collisions / _frames,
                    most: _total.most, histogram: _total.toArray(_frames), breeds: breeds};
        }

        /** The record as JSON text. */
        public function toText():String
        {
            return JSON.stringify(toObject(), null, 2);
        }

        private function record(found:Vector.<Agent>):void
        {
            var length:int = found.length;
            for (var i:int = 0; i < length; i += 2)
            {
                var breed:String = found[i].breed;
                var otherBreed:String = found[i + 1].breed;
                var pair:BreedPair = _lastPair;
                // mostly the pair of breeds that collided just before
                if (pair == null || pair.breed != breed || pair.otherBreed != otherBreed)
                {
                    pair = _lastPair = pairOf(breed, otherBreed);
                }
                pair.inFrame++;
            }
            _frames++;
            _collisions += length >> 1;
            _total.add(length >> 1);
            for (i = 0; i < _pairs.length; i++)
            {
                _pairs[i].endFrame();
            }
        }

        private function pairOf(breed:String, otherBreed:String):BreedPair
        {
            for each (var pair:BreedPair in _pairs)
            {
                if ((pair.breed == breed && pair.otherBreed == otherBreed) || (pair.breed == otherBreed && pair.otherBreed == breed))
                {
                    return pair;
                }
            }
            pair = new BreedPair(breed, otherBreed);
            _pairs.push(pair);
            return pair;
        }
    }
}

/** Two breeds, and how often they have collided. */
final class BreedPair
{
    /** The one's name. */
    public var breed:String;

    /** The other's name. */
    public var otherBreed:String;

    /** Their collisions in the frame under way. */
    public var inFrame:int = 0;

    /** Their collisions in all frames before it. */
    public var collisions:Number = 0;

    /** The frames in which there were any. */
    public var histogram:Histogram = new Histogram();

    /** Two breeds that have not collided yet. */
    public function BreedPair(breed:String, otherBreed:String)
    {
        this.breed = breed;
        this.otherBreed = otherBreed;
    }

    /** Counts the frame under way. */
    public function endFrame():void
    {
        if (inFrame > 0)
        {
            histogram.add(inFrame);
            collisions += inFrame;
            inFrame = 0;
        }
    }
}

/** In how many frames there were how many: exact up to 16, then in classes that double. */
final class Histogram
{
    private static const EXACT:int = 16;

    /** The most of any frame. */
    public var most:int = 0;

    private var _frames:Vector.<int> = new Vector.<int>();
    private var _added:int = 0;

    /** Nothing yet. */
    public function Histogram()
    {
    }

    /** Counts a frame that had a number of them. */
    public function add(number:int):void
    {
        most = Math.max(most, number);
        var index:int = number;
        if (number > EXACT)
        {
            for (index = EXACT; number > EXACT; number >>= 1)
            {
                index++;
            }
        }
        while (_frames.length <= index)
        {
            _frames.push(0);
        }
        _frames[index]++;
        _added++;
    }

    /** The classes that have frames. Of all the frames given, those that were not added had none. */
    public function toArray(frames:int):Array
    {
        var classes:Array = [];
        for (var i:int = 0; i < _frames.length; i++)
        {
            var count:int = i == 0 ? _frames[i] + frames - _added : _frames[i];
            if (count > 0)
            {
                classes.push({collisions: i <= EXACT ? i : leastOf(i), frames: count});
            }
        }
        return classes;
    }

    private static function leastOf(index:int):int
    {
        // 17 to 33 halve once to 16 or less, then 34 to 67, and so on
        return ((EXACT + 1) << (index - EXACT)) >> 1;
    }
}
