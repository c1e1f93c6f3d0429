package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.Fixtures;
    import support.RunningHash;
    import support.SolidModels;
    import support.agentAt;
    import support.landOf;

    /**
     * Agents that slide through mazes: never deeper in anything than 1e-9 of the larger extent, and among boxes as far as a point can that slides along
     * the same boxes, widened.
     */
    public class SlideTest
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/fortress.obj"];

        private static const HAIR:Number = 1e-9;

        // How thick a leaf of width 2 is. It counts as flat.
        private static const LEAF:Number = 1 / 4096;
        private static const HASH:String = "83dc168d";

        private static var sGreatLand:GreatLand;

        private var _random:SeededRandom = new SeededRandom(2204);
        private var _wrong:Complaints = new Complaints();

        // The walls: their middles and half-extents.
        private var _walls:Array;

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = landOf(BuiltInModel.cube(), BuiltInModel.sphere());
            sGreatLand.addModel(SolidModels.of("post", [[0.2, 0, 0, 0, false], [0.2, 0, 0, 0.2, false], [0.2, 0, 0, 0.4, false],
                            [0.2, 0, 0, 0.6, false]]));
            sGreatLand.addModel(new ObjModel("fortress", Fixtures.text("/assets/fortress.obj")));
        }

        // A slide along a wall that is touched, after one along the wall on the other side, is as it would be alone.
        [Test]
        public function dependsOnNoSlideBefore():void
        {
            var land:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.box(1, 40, 4, "wall"));
            for each (var name:String in ["tightest fits", "hierarchies", "triangles"])
            {
                var agents:Vector.<Agent> = new <Agent>[new Agent("sphere"), new Agent("wall"), new Agent("wall")];
                agents[1].moveTo(-5, 0, 0);
                agents[2].moveTo(5, 0, 0);
                var used:AgentQueries = new AgentQueries(EachCollider.make(name, land));
                for each (var side:int in [-1, 1, -1])
                {
                    var alone:AgentQueries = new AgentQueries(EachCollider.make(name, land));
                    assertEquals(name, slideBeside(side, agents, alone), slideBeside(side, agents, used));
                    assertTrue(name, used.distance(agents[0], agents[1]) > 0 && used.distance(agents[0], agents[2]) > 0);
                }
            }
        }

        // Slides the first agent along a wall that it touches. Returns where it is then.
        private static function slideBeside(side:int, agents:Vector.<Agent>, queries:AgentQueries):String
        {
            var mover:Agent = agents[0];
            mover.moveTo(4 * side, 0, 0);
            queries.update(agents);
            queries.slide(mover, 0, 1, 0);
            return mover.x + ", " + mover.y + ", " + mover.z;
        }

        // A card in the plane of a table's top is neither in the table nor stopped by it.
        [Test]
        public function aCardInThePlaneOfATableMoves():void
        {
            var land:GreatLand = landOf(BuiltInModel.box(3, 3, 1, "table"), new ObjModel("card", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4"));
            var table:Agent = new Agent("table");
            table.hierarchical = true;
            table.moveTo(0, 0, -1);
            for each (var name:String in ["tightest fits", "hierarchies", "triangles", "combinations, exact"])
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, land));
                var card:Agent = new Agent("card");
                queries.update(new <Agent>[table, card]);
                assertEquals(name, 1, queries.moveUntilTouch(card, 0.5, 0, 0));
                assertEquals(name, 1, queries.slide(card, -0.5, 0, 0));
                card.moveTo(0, 0, 0);
                assertEquals(name, 1, queries.moveUntilTouch(card, 0, 0, 0.5));
                card.moveTo(0, 0, 0);
                assertEquals(name, 0, queries.moveUntilTouch(card, 0, 0, -0.5));
                table.isOneWay = true;
                queries.update(new <Agent>[table, card]);
                assertEquals(name + ", one way", 0, queries.moveUntilTouch(card, 0, 0, -0.5));
                table.isOneWay = false;
            }
        }

        // A sheet on the table leaves two ways out, and one of them leads into the table.
        [Test]
        public function aCardInThePlaneOfASheetAndATableMoves():void
        {
            var land:GreatLand = landOf(BuiltInModel.box(3, 3, 1, "table"), new ObjModel("card", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4"));
            var table:Agent = new Agent("table");
            table.hierarchical = true;
            table.moveTo(0, 0, -1);
            var sheet:Agent = new Agent("card");
            sheet.size = 2;
            sheet.moveTo(0.3, 0.1, 0);
            for each (var name:String in ["triangles", "combinations, exact"])
            {
                for (var turned:int = 0; turned < 4; turned++)
                {
                    sheet.heading = turned < 2 ? 0 : 30;
                    sheet.roll = 180 * (turned % 2);
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, land));
                    var card:Agent = new Agent("card");
                    queries.update(new <Agent>[sheet, table, card]);
                    assertEquals(name + " " + turned, 1, queries.slide(card, 0.25, 0, 0));
                    assertTrue(name + " " + turned, card.z > 0);
                    card.moveTo(0, 0, 0);
                    assertTrue(name + " " + turned, queries.walk(card, 0.25, 0).stands);
                }
            }
        }

        // A leaf that ends its way close to a wall, without touching it, keeps the same gap on each side of it, along each axis.
        [Test]
        public function aLeafKeepsTheSameGapOnAllSides():void
        {
            var land:GreatLand = landOf(BuiltInModel.box(LEAF, 2, 2, "leaf 0"), BuiltInModel.box(2, LEAF, 2, "leaf 1"), BuiltInModel.box(2, 2, LEAF, "leaf 2"),
                    BuiltInModel.cube());
            var led:int = 0;
            for each (var name:String in ["tightest fits", "hierarchies", "triangles"])
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, land));
                for (var i:int = 0; i < 60; i++)
                {
                    var gap:Number = _random.logBetween(1e-12, 1e-9);
                    var axis:int = i % 3;
                    var before:Number = gapAfterSlide(queries, axis, -1, gap);
                    var after:Number = gapAfterSlide(queries, axis, 1, gap);
                    led += after > 1.5 * gap ? 1 : 0;
                    _wrong.addIf(!(Math.abs(before - after) < 1e-14), name + ", axis " + axis, before + " and " + after + " of " + gap);
                }
            }
            _wrong.assertNone();
            assertTrue(String(led), led > 40 && led < 170);
        }

        // Slides a leaf along the cube on a side of it. Returns how far it is from the cube then.
        private static function gapAfterSlide(queries:AgentQueries, axis:int, side:int, gap:Number):Number
        {
            var leaf:Agent = new Agent("leaf " + axis);
            var cube:Agent = new Agent("cube");
            var place:Array = [0, 0, 0];
            place[axis] = -side * ((1 + LEAF) / 2 + gap);
            // half of the way, so that the slide ends beside the cube
            place[(axis + 1) % 3] = -0.1;
            leaf.moveTo(place[0], place[1], place[2]);
            queries.update(new <Agent>[leaf, cube]);
            queries.slide(leaf, axis == 2 ? 0.2 : 0, axis == 0 ? 0.2 : 0, axis == 1 ? 0.2 : 0);
            return -side * [leaf.x, leaf.y, leaf.z][axis] - (1 + LEAF) / 2;
        }

        /** What is pushed out of a large agent, which it overlaps a little, does not come into a small one beside it. */
        [Test]
        public function aShortSlideLeadsIntoNoNeighbour():void
        {
            for each (var way:Number in [0.5, 1e-4, 1e-6])
            {
                for each (var walks:Boolean in [false, true])
                {
                    var large:Agent = agentAt("cube", 5e-4 - 500.5, 0, -300);
                    var mover:Agent = new Agent("cube");
                    var queries:AgentQueries = new AgentQueries(EachCollider.make("tightest fits", sGreatLand));
                    large.size = 1000;
                    queries.update(new <Agent>[large, agentAt("cube", 1.0001, 0, 0), mover]);
                    if (walks)
                    {
                        queries.walk(mover, 0, way);
                    }
                    else
                    {
                        queries.slide(mover, 0, way, 0);
                    }
                    assertTrue([way, walks, mover.x].join(), Math.abs(mover.x) < 1e-9);
                }
            }
        }

        [Test]
        public function amongBoxesAsFarAsCanBe():void
        {
            for each (var name:String in ["tightest fits", "hierarchies", "triangles"])
            {
                var gone:Number = 0;
                var possible:Number = 0;
                var touched:int = 0;
                for (var world:int = 0; world < 4; world++)
                {
                    var isTiled:Boolean = world % 2 == 1;
                    var agents:Vector.<Agent> = boxes(isTiled, 60);
                    var mover:Agent = agents[0];
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                    queries.update(agents);
                    var dx:Number = 0;
                    var dy:Number = 0;
                    var dz:Number = 0;
                    for (var step:int = Effort.choose(250, 65000); step > 0; step--)
                    {
                        if (step % 20 == 0 || dx == 0)
                        {
                            dx = _random.between(-0.5, 0.5);
                            dy = _random.between(-0.5, 0.5);
                            dz = isTiled ? 0 : _random.between(-0.2, 0.2);
                        }
                        var length:Number = Math.sqrt(dx * dx + dy * dy + dz * dz);
                        var far:Number = slidePoint(mover, dx, dy, dz);
                        var part:Number = queries.slide(mover, dx, dy, dz);
                        gone += Math.min(part * length, far);
                        possible += far;
                        touched += far < length ? 1 : 0;
                        _wrong.addIf(overlap(mover) > HAIR, name + ": deep", String(overlap(mover)));
                        if (Math.abs(mover.x) > 4.5 || Math.abs(mover.y) > 4.5 || Math.abs(mover.z) > 2)
                        {
                            mover.moveTo(0, 0, 0);
                            queries.moved(mover);
                        }
                    }
                }
                _wrong.addIf(gone < 0.999 * possible, name + ": not far enough", gone + " of " + possible);
                assertTrue(name + ": touched " + touched, touched > 200);
            }
            _wrong.assertNone();
        }

        [Test]
        public function theSameOnAllMachines():void
        {
            var hash:RunningHash = new RunningHash();
            for each (var name:String in EachCollider.NAMES)
            {
                var agents:Vector.<Agent> = mixture(EachCollider.make(name, sGreatLand), false);
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                queries.update(agents);
                for (var step:int = 0; step < 60; step++)
                {
                    queries.slide(agents[0], 0.2 * Math.sqrt(step % 7) - 0.3, 0.4 - 0.1 * (step % 9), 0.02 * (step % 3 - 1));
                    for each (var at:Number in [agents[0].x, agents[0].y, agents[0].z])
                    {
                        // to a millionth
                        hash.addNumber(Math.round(at * 1e6));
                    }
                }
            }
            assertEquals(HASH, hash.toString());
        }

        // A point among the boxes, each wider by the mover: how far it slides, all faces kept that it has come to.
        private function slidePoint(mover:Agent, dx:Number, dy:Number, dz:Number):Number
        {
            var half:Number = mover.size / 2;
            var at:Array = [mover.x, mover.y, mover.z + half];
            var rest:Array = [dx, dy, dz];
            var gone:Number = 0;
            for (var round:int = 0; round < 4; round++)
            {
                var first:Number = 1;
                var axis:int = -1;
                for each (var wall:Array in _walls)
                {
                    var enters:Number = -Infinity;
                    var leaves:Number = Infinity;
                    var through:int = -1;
                    for (var i:int = 0; i < 3; i++)
                    {
                        var reach:Number = wall[3 + i] + half - 1e-8;
                        var from:Number = at[i] - wall[i];
                        if (rest[i] == 0)
                        {
                            if (Math.abs(from) >= reach)
                            {
                                leaves = -Infinity;
                            }
                            continue;
                        }
                        var side:Number = rest[i] > 0 ? 1 : -1;
                        var enter:Number = (-side * reach - from) / rest[i];
                        if (enter > enters)
                        {
                            enters = enter;
                            through = i;
                        }
                        leaves = Math.min(leaves, (side * reach - from) / rest[i]);
                    }
                    if (enters < leaves && leaves > 0 && enters < first && through >= 0 && enters > -1e-6)
                    {
                        first = Math.max(enters, 0);
                        axis = through;
                    }
                }
                gone += first * Math.sqrt(rest[0] * rest[0] + rest[1] * rest[1] + rest[2] * rest[2]);
                for (i = 0; i < 3; i++)
                {
                    at[i] += first * rest[i];
                    rest[i] *= 1 - first;
                }
                if (axis < 0)
                {
                    break;
                }
                rest[axis] = 0;
            }
            return gone;
        }

        // How far the mover overlaps the wall that it overlaps most.
        private function overlap(mover:Agent):Number
        {
            var half:Number = mover.size / 2;
            var most:Number = 0;
            for each (var wall:Array in _walls)
            {
                most = Math.max(most, Math.min(wall[3] + half - Math.abs(mover.x - wall[0]), wall[4] + half - Math.abs(mover.y - wall[1]),
                            wall[5] + half - Math.abs(mover.z + half - wall[2])));
            }
            return most;
        }

        // The mover and cubes around it: of any size, or of one size on the squares of a grid.
        private function boxes(isTiled:Boolean, count:int):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new <Agent>[new Agent("cube")];
            _walls = [];
            agents[0].size = isTiled ? 0.7 : 0.4;
            while (_walls.length < count)
            {
                var wall:Agent = new Agent("cube");
                wall.size = isTiled ? 1 : _random.between(0.3, 1.5);
                wall.moveTo(_random.between(-4, 4), _random.between(-4, 4), _random.between(-1.5, 1));
                if (isTiled)
                {
                    wall.moveTo(_random.integer(-4, 4), _random.integer(-4, 4), 0);
                }
                var half:Number = wall.size / 2;
                _walls.push([wall.x, wall.y, wall.z + half, half, half, half]);
                if (overlap(agents[0]) > 0)
                {
                    _walls.pop();
                    continue;
                }
                agents.push(wall);
            }
            return agents;
        }

        // A mover among spheres, posts and turned cubes, or in a fortress.
        private function mixture(collider:Collider, isFortress:Boolean):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new <Agent>[new Agent(_random.pick(["cube", "sphere", "post"]))];
            agents[0].size = _random.between(0.2, 0.6);
            agents[0].hierarchical = _random.chance();
            for (var i:int = 0; i < 40; i++)
            {
                var other:Agent = new Agent(_random.pick(["cube", "sphere", "post"]));
                other.size = _random.between(0.5, 2);
                other.heading = _random.between(0, 360);
                other.pitch = _random.chance() ? 0 : _random.between(-90, 90);
                other.hierarchical = _random.chance();
                other.moveTo(_random.between(-5, 5), _random.between(-5, 5), _random.between(-1.5, 1));
                agents.push(other);
            }
            if (isFortress)
            {
                agents.length = 2;
                agents[1] = new Agent("fortress");
                agents[1].size = 9;
                agents[1].hierarchical = true;
                agents[1].heading = 20;
            }
            putFree(collider, agents);
            return agents;
        }

        // Where the mover touches nothing.
        private function putFree(collider:Collider, agents:Vector.<Agent>):void
        {
            var isFree:Boolean = false;
            for (var tries:int = 0; tries < 2000 && !isFree; tries++)
            {
                agents[0].jumpTo(_random.between(-6, 6), _random.between(-6, 6), _random.between(-1, 1.5));
                isFree = true;
                for (var i:int = 1; i < agents.length && isFree; i++)
                {
                    isFree = !collider.areColliding(agents[0], agents[i]);
                }
            }
        }
    }
}
