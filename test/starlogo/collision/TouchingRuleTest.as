package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.queries.AgentQueries;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.TouchingPair;
    import support.landOf;

    /**
     * Touching is one rule: what touches but for the rounding of its decimals touches in every system, standing, moving and asked, wherever in the
     * world; and what has a gap does not, in every system that is exact for its shape.
     */
    public class TouchingRuleTest
    {
        private static const COUNT:int = 1999;

        /** Each is a collider and how many of the two agents are hierarchical. */
        private static const SYSTEMS:Array = [["bins", 0], ["tightest fits", 0], ["combinations", 0], ["hierarchies", 0], ["triangles", 0],
                ["combinations", 1], ["combinations", 2]];
        private static const STANDING:Array = ["found", "found the other way round", "asked", "asked the other way round"];

        // Who sweeps; from where and to where the two go: along, aside and behind, as TouchingPair.place() has it.
        private static const SWEPT:Array = [
                ["moving along, both sweep", true, true, [0, 0, 1], [0, 0, 1], [0, 0, 0], [0, 0, 0]],
                ["moving along, one sweeps", true, false, [0, 0, 1], [0, 0, 1], [0, 0, 0], [0, 0, 0]],
                ["moving along, the other sweeps", false, true, [0, 0, -1], [0, 0, -1], [0, 0, 0], [0, 0, 0]],
                ["one passes", true, false, [0, -1, 0], [0, 0, 0], [0, 1, 0], [0, 0, 0]],
                ["the other passes", true, false, [0, 0, 0], [0, 1, 0], [0, 0, 0], [0, -1, 0]],
                ["both pass", true, true, [0, -1, 1], [0, 1, 1], [0, 1, 0], [0, -1, 0]],
                ["one comes", true, false, [3, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]],
                ["the other comes", false, true, [0, 0, 0], [3, 0, 0], [0, 0, 0], [0, 0, 0]],
                ["one leaves", true, false, [0, 0, 0], [0, 0, 0], [3, 0, 0], [0, 0, 0]],
                ["both leave", false, true, [0, 0, 1], [0, 0, 1], [3, 0, 0], [5, 0, 0]],
                ["both come", true, false, [3, 0, 1], [5, 0, 1], [0, 0, 0], [0, 0, 0]]];

        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());
        private var _colliders:Array = [];
        private var _random:SeededRandom = new SeededRandom(1999);
        private var _a:Agent = new Agent("sphere");
        private var _b:Agent = new Agent("sphere");
        private var _agents:Vector.<Agent> = new <Agent>[_a, _b];
        private var _wrong:Complaints = new Complaints();
        private var _questions:int = 0;

        [Before]
        public function makeGame():void
        {
            for each (var system:Array in SYSTEMS)
            {
                _colliders.push(EachCollider.make(system[0], _greatLand));
            }
        }

        [Test]
        public function standingPairsTouchInAllSystems():void
        {
            var differing:int = 0;
            var shapes:Object = {sphere: 0, cube: 0, "sphere and cube": 0};
            for (var n:int = 0; n < COUNT; n++)
            {
                var pair:TouchingPair = new TouchingPair(_random.pick(TouchingPair.SHAPES), _random);
                shapes[pair.shape]++;
                differing += ask(pair, STANDING, true) ? 1 : 0;
            }
            trace("  of " + COUNT + " pairs that touch, the systems differ about " + differing);
            assertTrue(shapes.sphere > COUNT / 4 && shapes.cube > COUNT / 4);
            assertTrue(_questions + " questions", _questions > 4 * 4 * COUNT);
            _wrong.assertNone();
        }

        [Test]
        public function pairsTouchOnTheirWaysInAllSystems():void
        {
            var count:int = Effort.choose(120, COUNT);
            for (var n:int = 0; n < count; n++)
            {
                ask(new TouchingPair(_random.pick(TouchingPair.SHAPES), _random), SWEPT, true);
            }
            assertTrue(_questions + " questions", _questions > 4 * SWEPT.length * count);
            _wrong.assertNone();
        }

        [Test]
        public function pairsTouchFarAway():void
        {
            for each (var offset:Number in [1e4, 1e6, 1e8])
            {
                askAbout(offset, true);
            }
            _wrong.assertNone();
        }

        [Test]
        public function pairsWithAGapDoNotTouch():void
        {
            for each (var offset:Number in [0, 1e4, 1e6, 1e8])
            {
                askAbout(offset, false);
            }
            _wrong.assertNone();
        }

        /** A model's vertex is so far from its middle that it cancels the agent's place: the place's rounding counts, though the vertex is near the origin. */
        [Test]
        public function pairsAreFoundWhoseOffsetsCancelTheirPlaces():void
        {
            _greatLand.addModel(new Model("vertex", new <Number>[1, 2, -3], null, Model.AS_GIVEN));
            _a = new Agent("vertex");
            _b = new Agent("vertex");
            for each (var size:Number in [1, 1e3, 1e6])
            {
                for (var n:int = 0; n < 40; n++)
                {
                    _a.size = _b.size = size;
                    _a.moveTo(-size, -2 * size, 3 * size);
                    // shorter than the margins of the two places, which are 3.6e-15 of the size each
                    _b.moveTo((_random.between(1, 6) * 1e-15 - 1) * size, -2 * size, 3 * size);
                    _agents = new <Agent>[_a, _b];
                    for (var i:int = 0; i < SYSTEMS.length; i++)
                    {
                        setSystem(i);
                        for each (var manner:String in STANDING)
                        {
                            _wrong.addIf(!isCollidingNow(manner, _colliders[i]), nameOf(i) + ", size " + size, manner + ", " + (_b.x - _a.x));
                        }
                        var queries:AgentQueries = new AgentQueries(_colliders[i]);
                        queries.update(_agents);
                        _wrong.addIf(queries.touching(_a).length != 1, nameOf(i) + ", size " + size, "touching, " + (_b.x - _a.x));
                    }
                }
            }
            _wrong.assertNone();
        }

        /**
         * Motions end at the last place along a line at which two agents touch, or go on behind it. Some are hardly longer than a rounding. The
         * contacts have no depth, and a normal against the motion.
         */
        [Test]
        public function whatTouchesLateInAMotionIsMet():void
        {
            var count:int = Effort.choose(120, 4000, 20);
            var land:GreatLand = new GreatLand();
            land.loadHulls = true;
            land.addModel(BuiltInModel.sphere());
            land.addModel(BuiltInModel.cube());
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var collider:Collider = EachCollider.make(name, land);
                var collision:Collision = new Collision(collider);
                var depths:Array = [];
                var away:Array = [];
                collision.onCollision("a", "b", function(a:Agent, b:Agent, contact:Contact):void
                    {
                        depths.push(contact.depth);
                        away.push(contact.normal.dotProduct(direction));
                    });
                for (var i:int = 0; i < count; i++)
                {
                    _a = new Agent(_random.pick(["sphere", "cube"]), "a");
                    _b = new Agent(_random.pick(["sphere", "cube"]), "b");
                    _agents = new <Agent>[_a, _b];
                    _a.size = Math.pow(10, _random.between(-0.5, 0.5));
                    _a.sweeps = true;
                    _a.hierarchical = i % 2 == 0;
                    _a.collideAs = _b.collideAs = _random.pick(["tightest", "hull"]);
                    var offset:Number = _random.pick([0, 10]);
                    _b.moveTo(offset * _random.next(), offset * _random.next(), offset * _random.next());
                    var direction:Vector3D = _random.pick([new Vector3D(1, 0, 0), new Vector3D(_random.normal(), _random.normal(), _random.normal())]);
                    var touching:Number = 0;
                    var apart:Number = 8 / direction.length;
                    for (var k:int = 0; k < 70; k++)
                    {
                        var middle:Number = (touching + apart) / 2;
                        moveAlong(direction, middle);
                        touching = collider.areColliding(_a, _b) ? middle : touching;
                        apart = collider.areColliding(_a, _b) ? apart : middle;
                    }
                    moveAlong(direction, touching + Math.pow(10, _random.between(-9, -1)));
                    collision.update(_agents);
                    depths.length = away.length = 0;
                    moveAlong(direction, _random.pick([touching, touching - _random.between(0, 0.3) / direction.length]));
                    collision.update(_agents);
                    var said:String = "pair " + i + ", " + _a.shape + ", " + _b.shape;
                    _wrong.addIf(depths.length != 1, name, said);
                    _wrong.addIf(!(depths[0] <= 1e-8), name + ", depth", said + ", " + depths);
                    _wrong.addIf(!(away[0] > -1e-6), name + ", normal", said + ", " + away);
                }
            }
            _wrong.assertNone();
        }

        private function moveAlong(direction:Vector3D, distance:Number):void
        {
            _a.moveTo(_b.x + distance * direction.x, _b.y + distance * direction.y, _b.z + distance * direction.z);
        }

        private function askAbout(offset:Number, areTouching:Boolean):void
        {
            var count:int = Effort.choose(35, 700);
            _questions = 0;
            for (var n:int = 0; n < count; n++)
            {
                var pair:TouchingPair = new TouchingPair(_random.pick(TouchingPair.SHAPES), _random, offset * _random.pick([-1, 1]), 1 + n % 7);
                pair.gap = areTouching ? 0 : _random.pick([1, 1, 10, 1e4]) * (1e-9 * pair.size + 1e-12 * pair.distance);
                assertTrue(pair + "", pair.distance >= offset / 2);
                ask(pair, STANDING, areTouching);
                ask(pair, SWEPT, areTouching);
            }
            assertTrue(_questions + " questions", _questions > 3 * (SWEPT.length + STANDING.length) * count);
        }

        // Asks all systems about a pair that touches or has a gap. Returns whether they differ.
        private function ask(pair:TouchingPair, manners:Array, expected:Boolean):Boolean
        {
            var hits:int = 0;
            var asked:int = 0;
            for (var i:int = 0; i < SYSTEMS.length; i++)
            {
                if (!isAbout(i, pair, expected))
                {
                    continue;
                }
                setSystem(i);
                pair.resize(_a, _b);
                for each (var manner:Object in manners)
                {
                    var isHit:Boolean = isColliding(manner, pair, _colliders[i]);
                    asked++;
                    hits += isHit ? 1 : 0;
                    _wrong.addIf(isHit != expected, nameOf(i) + ", " + pair.shape + ", " + (manners === STANDING ? "standing" : "moving"), (manner is Array ? manner[0] : manner) + ", " + pair);
                }
            }
            _questions += asked;
            return hits > 0 && hits < asked;
        }

        // Whether a system takes the agents for what touches, or has the gap.
        private static function isAbout(system:int, pair:TouchingPair, isTouching:Boolean):Boolean
        {
            var name:String = SYSTEMS[system][0];
            var isMesh:Boolean = name == "hierarchies" || name == "triangles" || SYSTEMS[system][1] > 0;
            if (pair.shape != "cube")
            {
                // a mesh reaches as far as the sphere along the axes alone, and what stands for it in a hierarchy may reach further
                return !isMesh || pair.isAlongAxis && (isTouching || name == "triangles");
            }
            return name != "bins" || pair.isAlongAxis;
        }

        private function setSystem(system:int):void
        {
            _a.hierarchical = SYSTEMS[system][1] > 0;
            _b.hierarchical = SYSTEMS[system][1] > 1;
        }

        private function isColliding(manner:Object, pair:TouchingPair, collider:Collider):Boolean
        {
            _a.sweeps = manner is Array && manner[1];
            _b.sweeps = manner is Array && manner[2];
            if (manner is Array)
            {
                return isMet(collider, pair, manner[3], manner[4], manner[5], manner[6]);
            }
            pair.place(_a, false, 0, 0, 0, true);
            pair.place(_b, true, 0, 0, 0, true);
            return isCollidingNow(String(manner), collider);
        }

        private function isCollidingNow(manner:String, collider:Collider):Boolean
        {
            switch (manner)
            {
                case "found":
                    return collider.findCollisions(_agents).length == 2;
                case "found the other way round":
                    _agents.reverse();
                    return collider.findCollisions(_agents).length == 2;
                case "asked":
                    return collider.areColliding(_a, _b);
                default:
                    return collider.areColliding(_b, _a);
            }
        }

        private function isMet(collider:Collider, pair:TouchingPair, fromA:Array, fromB:Array, toA:Array, toB:Array):Boolean
        {
            pair.place(_a, false, fromA[0], fromA[1], fromA[2], true);
            pair.place(_b, true, fromB[0], fromB[1], fromB[2], true);
            collider.findCollisions(_agents);
            pair.place(_a, false, toA[0], toA[1], toA[2], false);
            pair.place(_b, true, toB[0], toB[1], toB[2], false);
            return collider.findCollisions(_agents).length == 2;
        }

        private static function nameOf(system:int):String
        {
            return SYSTEMS[system][0] + (SYSTEMS[system][1] > 0 ? " with " + SYSTEMS[system][1] + " hierarchical" : "");
        }
    }
}
