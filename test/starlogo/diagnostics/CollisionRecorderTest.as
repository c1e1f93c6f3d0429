package starlogo.diagnostics
{
    import evaluation.EveryPairSystem;
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BaseCollider;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.assertThrows;
    import support.create;
    import support.ignore;
    import support.landOf;

    public class CollisionRecorderTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());

        [Test]
        public function recordsFramesByBreedPair():void
        {
            var agents:Vector.<Agent> = new <Agent>[new Agent("sphere", "cats"), new Agent("sphere", "dogs"), new Agent("sphere", "dogs")];
            var recorder:CollisionRecorder = new CollisionRecorder(new BinCollider(_greatLand));
            recorder.findCollisions(agents);
            agents[1].moveTo(20, 0, 0);
            recorder.findCollisions(agents);
            agents[2].moveTo(-20, 0, 0);
            recorder.findCollisions(agents);
            recorder.findCollisions(agents);

            var record:Object = JSON.parse(recorder.toText());
            assertEquals(4, record.frames);
            assertEquals(4, record.collisions);
            assertEquals(1, record.mean);
            assertEquals(3, record.most);
            assertEquals('[[0,2],[1,1],[3,1]]', pairs(record.histogram));
            assertEquals(2, record.breeds.length);
            assertEquals("cats and dogs come first, having collided most", "cats,dogs", record.breeds[0].breeds);
            assertEquals(3, record.breeds[0].collisions);
            assertEquals("of all frames, not only those with a collision", 0.75, record.breeds[0].mean);
            assertEquals(2, record.breeds[0].most);
            assertEquals('[[0,2],[1,1],[2,1]]', pairs(record.breeds[0].histogram));
            assertEquals('[[0,3],[1,1]]', pairs(record.breeds[1].histogram));
        }

        /** A frame asks only about the pairs of breeds that collide in it: of 19,900 pairs of breeds that have collided, here none. */
        [Test]
        public function framesAfterManyPairsOfBreedsAreCheap():void
        {
            var agents:Vector.<Agent> = new <Agent>[];
            for (var i:int = 0; i < 200; i++)
            {
                agents.push(new Agent("sphere", "breed " + i));
            }
            var recorder:CollisionRecorder = new CollisionRecorder(new BinCollider(_greatLand));
            var before:Number = timeOfEmptyFrames(recorder);
            recorder.clear();
            recorder.findCollisions(agents);
            assertEquals(19900, recorder.collisions);
            var after:Number = timeOfEmptyFrames(recorder);
            assertTrue(after + " ms, and " + before + " ms before", after < 10 * before + 500);
            assertEquals(19900, recorder.toObject().breeds.length);
            assertEquals(301, recorder.toObject().breeds[0].histogram[0].frames + recorder.toObject().breeds[0].histogram[1].frames);
        }

        private static function timeOfEmptyFrames(recorder:CollisionRecorder):Number
        {
            var from:Number = getTimer();
            for (var i:int = 0; i < 300; i++)
            {
                recorder.findCollisions(new <Agent>[]);
            }
            return getTimer() - from;
        }

        [Test]
        public function numbersAboveSixteenAreInClassesThatDouble():void
        {
            var recorder:CollisionRecorder = new CollisionRecorder(new EveryPairSystem());
            // 15, 21, 28, 36, 66 and 78 pairs
            for each (var count:int in [6, 7, 8, 9, 12, 13])
            {
                recorder.findCollisions(Scenes.crowd(count, "spheres").agents);
            }
            assertEquals('[[15,1],[17,2],[34,2],[68,1]]', pairs(recorder.toObject().histogram));
        }

        [Test]
        public function everyFrameIsInTheHistogramAndEveryCollisionInABreedPair():void
        {
            var scene:Scene = Scenes.scattered(600, "spheres");
            for (var i:int = 0; i < scene.agents.length; i++)
            {
                scene.agents[i].breed = ["cats", "dogs", "mice"][i % 3];
            }
            var recorder:CollisionRecorder = new CollisionRecorder(new BinCollider(_greatLand));
            for (var frame:int = 0; frame < 20; frame++)
            {
                scene.step();
                recorder.findCollisions(scene.agents);
            }
            var record:Object = recorder.toObject();
            assertEquals(20, sum(record.histogram, "frames"));
            assertEquals("six pairs of three breeds", 6, record.breeds.length);
            assertTrue(record.collisions > 100);
            assertEquals(record.collisions, sum(record.breeds, "collisions"));
            for each (var pair:Object in record.breeds)
            {
                assertEquals(20, sum(pair.histogram, "frames"));
            }
        }

        [Test]
        public function passesOnInterestsAndStatistics():void
        {
            var recorder:CollisionRecorder = new CollisionRecorder(new BinCollider(_greatLand));
            var collision:Collision = new Collision(recorder);
            collision.onCollision("cats", "dogs", ignore);
            collision.update(new <Agent>[new Agent("sphere", "cats"), new Agent("sphere", "dogs"), new Agent("sphere", "mice")]);
            assertEquals("mice have no handlers", 1, recorder.collisions);
            assertEquals(1, collision.statistics.agentsSkipped);
            assertEquals(1, collision.statistics.collisions);
            assertTrue(collision.statistics.sphereSphereTests > 0);
        }

        [Test]
        public function aRecorderInsideASystemOfTheGamesRecordsItsFrames():void
        {
            var recorder:CollisionRecorder = new CollisionRecorder(new BinCollider(_greatLand));
            var collision:Collision = new Collision(new BaseCollider(recorder));
            collision.onCollision("cats", "dogs", ignore);
            collision.update(new <Agent>[new Agent("sphere", "cats"), new Agent("sphere", "dogs")]);
            assertEquals("1 1 1", [recorder.frames, recorder.findTimes.frames, recorder.frameTimes.frames].join(" "));
        }

        [Test]
        public function aRecorderInsideAnotherRecordsTheSameFrames():void
        {
            var inner:CollisionRecorder = new CollisionRecorder(new BinCollider(_greatLand));
            var outer:CollisionRecorder = new CollisionRecorder(inner);
            var collision:Collision = new Collision(outer);
            collision.onCollision("cats", "dogs", ignore);
            for (var frame:int = 1; frame <= 3; frame++)
            {
                collision.update(new <Agent>[new Agent("sphere", "cats"), new Agent("sphere", "dogs")]);
                assertEquals(frame, inner.frameTimes.frames);
                assertEquals(frame, inner.findTimes.frames);
            }
            assertEquals(outer.toText(), inner.toText());
        }

        [Test]
        public function theGroundAndTheEdgesAreBreedsToo():void
        {
            var recorder:CollisionRecorder = new CollisionRecorder(new BinCollider(_greatLand));
            var collision:Collision = new Collision(recorder);
            collision.terrain = new Terrain(3, 3, 1, -1, -1);
            collision.bounds = new WorldBounds(0, -9, -9, 9, 9, 9);
            collision.onCollision("cats", Collision.TERRAIN, ignore);
            collision.onCollision("cats", Collision.EDGE, ignore);
            collision.update(new <Agent>[new Agent("sphere", "mice"), new Agent("sphere", "cats")]);
            assertEquals(2, recorder.collisions);
            var record:Object = recorder.toObject();
            assertEquals("cats,*edge,cats,*terrain", [record.breeds[0].breeds, record.breeds[1].breeds].sort().join());
        }

        [Test]
        public function clearForgets():void
        {
            var recorder:CollisionRecorder = new CollisionRecorder(new EveryPairSystem());
            recorder.findCollisions(Scenes.crowd(4, "spheres").agents);
            recorder.clear();
            assertEquals('{"breeds":[],"collisions":0,"frames":0,"histogram":[],"mean":0,"most":0}', sortedText(recorder.toObject()));
            recorder.findCollisions(Scenes.crowd(3, "spheres").agents);
            assertEquals("and begins anew", '[[3,1]]', pairs(recorder.toObject().histogram));
            assertEquals(1, recorder.toObject().breeds.length);
            assertEquals(3, recorder.toObject().breeds[0].collisions);
        }

        [Test]
        public function itsStatisticsAreThoseOfItsSystem():void
        {
            var system:CountedPairs = new CountedPairs();
            assertTrue(new CollisionRecorder(system).statistics === system.statistics);
        }

        [Test]
        public function needsASystem():void
        {
            assertThrows(ArgumentError, /collisionSystem/, create, CollisionRecorder, null);
        }

        private static function pairs(histogram:Array):String
        {
            return JSON.stringify(histogram.map(function(entry:Object, index:int, all:Array):Array
                    {
                        return [entry.collisions, entry.frames];
                    }));
        }

        private static function sum(list:Array, field:String):Number
        {
            var total:Number = 0;
            for each (var entry:Object in list)
            {
                total += entry[field];
            }
            return total;
        }

        private static function sortedText(record:Object):String
        {
            var fields:Array = [];
            for (var field:String in record)
            {
                fields.push(JSON.stringify(field) + ":" + JSON.stringify(record[field]));
            }
            return "{" + fields.sort().join(",") + "}";
        }
    }
}

import starlogo.agents.Agent;
import starlogo.collision.CollisionStatistics;
import starlogo.collision.CollisionSystem;

/** Finds as many pairs as it is told. */
class CountedPairs implements CollisionSystem
{
    public var count:int = 0;

    private var _statistics:CollisionStatistics = new CollisionStatistics();

    public function get statistics():CollisionStatistics
    {
        return _statistics;
    }

    public function areColliding(a:Agent, b:Agent):Boolean
    {
        return true;
    }

    public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
    {
        out = new Vector.<Agent>();
        var agent:Agent = new Agent("sphere");
        for (var i:int = 0; i < count; i++)
        {
            out.push(agent, agent);
        }
        return out;
    }
}
